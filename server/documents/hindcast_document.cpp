#include "server/documents/hindcast_document.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <utility>

#include "server/documents/member_warnings.hpp"
#include "server/documents/or_null.hpp"
#include "server/documents/warning_lines.hpp"
#include "solver/hindcast/weights.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::Distance;
using solver::Prediction;

/// Rows of a sample with less are left out: together they are far below what a member counts.
constexpr double least_weight = 1e-8;

json to_json(const solver::Weights& weights) {
  return {{"effective_members", weights.effective}, {"pareto_k", or_null(weights.pareto_k)}};
}

json to_json(const solver::CentralInterval& s) { return {s.low, s.median, s.high}; }

json to_json(const solver::Observed& o) {
  json out = json::object();
  if (o.value_m) out = {{"value", *o.value_m}, {"sd_ln", o.sd_ln}};
  if (o.at_least_m) out["at_least"] = *o.at_least_m;
  if (o.at_most_m) out["at_most"] = *o.at_most_m;
  return out;
}

json to_json(const Prediction& p) {
  return {{"median_m", p.median_m},
          {"interval_m", {p.low_m, or_null(p.high_m)}},
          {"text", interval_text(p)},
          {"beyond", p.beyond},
          {"hit", p.hit ? json(*p.hit) : json()},
          {"pit", or_null(p.pit)},
          {"crps_ln", or_null(p.crps_ln)},
          {"crps_of_rule_ln", or_null(p.crps_of_rule_ln)}};
}

json slide_document(const Hindcast& h, std::size_t e) {
  const auto& slide = h.summary.slides[e];
  json runs = json::object();
  for (const auto& [what, count] : slide.runs) runs[what] = count;
  json out{{"name", h.asked.plan.slides[e].name},
           {"source", h.asked.cases[e].source},
           {"runs", runs},
           {"share_that_slides",
            {{"prior", slide.slides_prior}, {"from_others", slide.slides_from_others}}},
           {"from_others", to_json(slide.others)}};
  for (const Distance distance : solver::distances) {
    const auto* observed = solver::observed_of(h.asked.plan.slides[e], distance);
    if (observed == nullptr) continue;
    json& one = out[to_string(distance)];
    one["observed"] = to_json(*observed);
    const auto predicted = slide.by_distance.find(distance);
    one["predicted"] = predicted == slide.by_distance.end() ? json() : to_json(predicted->second);
  }
  return out;
}

json score_document(const solver::DistanceScore& score) {
  return {{"hits", score.coverage.hits},
          {"of", score.coverage.of},
          {"chance_of_so_few", score.coverage.chance},
          {"sharpness", or_null(score.sharpness)},
          {"mean_crps_ln", or_null(score.mean_crps_ln)},
          {"mean_crps_of_rule_ln", or_null(score.mean_crps_of_rule_ln)}};
}

json weights_document(const solver::HindcastSummary& s) {
  json out = to_json(s.posterior);
  out["trusted"] = s.doubts.empty();
  out["doubts"] = s.doubts;
  out["largest_good_pareto_k"] = solver::largest_good_k(s.members);
  out["likelihood_exponent"] = s.exponent;
  out["whole_likelihood"] = to_json(s.full);
  out["cut_short"] = s.cut_short;
  return out;
}

json inputs_document(const Hindcast& h) {
  json inputs = json::array();
  for (const auto& shift : h.summary.inputs) {
    inputs.push_back({{"name", h.asked.plan.draws.inputs[shift.input].name},
                      {"path", h.asked.places[shift.input].path},
                      {"prior", to_json(shift.prior)},
                      {"posterior", to_json(shift.posterior)},
                      {"shift", shift.shift},
                      {"narrowing", shift.narrowing}});
  }
  return inputs;
}

std::string names_of(const solver::HindcastPlan& plan) {
  std::string names;
  for (const auto& slide : plan.slides) names += (names.empty() ? "" : ", ") + slide.name;
  return names;
}

/// Weights as written, which still add up to 1 to 6 digits.
double rounded(double weight) { return std::round(weight * 1e10) / 1e10; }

std::string scores_text(const solver::DistanceScore& score, const char* name, double confidence) {
  std::string text =
      fmt::format("{}: {} of {} within {:.0f} %, chance of so few {:.2f}", name,
                  score.coverage.hits, score.coverage.of, 100 * confidence, score.coverage.chance);
  text += score.sharpness ? fmt::format(", intervals of a factor of {:.1f}", *score.sharpness)
                          : std::string(", intervals without an upper end");
  if (score.mean_crps_ln) text += fmt::format(", CRPS {:.2f}", *score.mean_crps_ln);
  if (score.mean_crps_of_rule_ln) {
    text += fmt::format(" (lognormal rule {:.2f})", *score.mean_crps_of_rule_ln);
  }
  return text + "\n";
}

std::string slides_text(const Hindcast& h) {
  std::string text = fmt::format("{:<28}{:<14}{:>12}  {:<22}{:>8}{:>6}\n", "from the others", "",
                                 "observed m", "predicted m", "median", "hit");
  for (std::size_t e = 0; e < h.summary.slides.size(); ++e) {
    for (const auto& [distance, p] : h.summary.slides[e].by_distance) {
      const auto& slide = h.asked.plan.slides[e];
      text += fmt::format("{:<28}{:<14}{:>12}  {:<22}{:>8.1f}{:>6}\n", slide.name,
                          to_string(distance), observed_text(*solver::observed_of(slide, distance)),
                          interval_text(p), p.median_m,
                          !p.hit   ? "-"
                          : *p.hit ? "yes"
                                   : "no");
    }
  }
  return text;
}

}  // namespace

HindcastRow row_of(const HindcastFile& file, const solver::SharedDraws& draws,
                   const solver::HindcastRun& run, std::optional<SectionResult> result) {
  return {run, file.inputs_of(draws, run), draws.particle_seed(run, file.slide(run)),
          std::move(result)};
}

std::vector<solver::HindcastRun> still_wanted(const std::vector<solver::HindcastRun>& runs,
                                              const std::vector<HindcastRow>& rows) {
  std::set<std::pair<std::size_t, std::size_t>> slid;
  for (const HindcastRow& row : rows) {
    if (!row.result || !solver::outcome_of(*row.result).slid().value_or(false)) continue;
    slid.emplace(row.run.slide, row.run.member);
  }
  std::vector<solver::HindcastRun> wanted;
  for (const auto& run : runs) {
    if (!slid.contains({run.slide, run.member})) wanted.push_back(run);
  }
  return wanted;
}

solver::SlideOutcomes outcomes_of(const HindcastFile& file, const solver::SharedDraws& draws,
                                  const std::vector<HindcastRow>& rows) {
  const std::vector<std::vector<solver::MemberOutcome>> none(draws.members());
  solver::SlideOutcomes outcomes(file.plan.slides.size(), none);
  for (const HindcastRow& row : rows) {
    outcomes.at(row.run.slide)
        .at(row.run.member)
        .push_back(row.result ? solver::outcome_of(*row.result) : solver::MemberOutcome{});
  }
  return outcomes;
}

std::string posterior_label(const Hindcast& hindcast) {
  const auto& plan = hindcast.asked.plan;
  return fmt::format(
      "{}: Leda after {} past slide{} alone ({}); {}", hindcast.asked.name, plan.slides.size(),
      plan.slides.size() == 1 ? "" : "s", names_of(plan),
      hindcast.summary.doubts.empty() ? hindcast_condition : "its weights are not to be trusted");
}

json posterior_inputs(const Hindcast& hindcast) {
  const auto& weights = hindcast.summary.posterior.values;
  const auto& inputs = hindcast.asked.plan.draws.inputs;
  json out = json::array();
  for (std::size_t i = 0; i < inputs.size() && hindcast.summary.posterior.effective > 0; ++i) {
    if (inputs[i].scope != solver::Scope::region) continue;
    json values = json::array(), kept = json::array();
    for (std::size_t m = 0; m < weights.size(); ++m) {
      if (weights[m] < least_weight) continue;
      values.push_back(hindcast.asked.inputs_of(hindcast.draws, {0, m, 0})[i]);
      kept.push_back(rounded(weights[m]));
    }
    json input = hindcast.asked.inputs.at(i);
    input["distribution"] = {
        {"type", "sample"}, {"set", hindcast.asked.name}, {"values", values}, {"weights", kept}};
    out.push_back(std::move(input));
  }
  return out;
}

json to_document(const Hindcast& hindcast) {
  const auto& plan = hindcast.asked.plan;
  const auto& s = hindcast.summary;
  double core_s = 0;
  for (const HindcastRow& row : hindcast.rows) core_s += row.result ? row.result->run_time_s : 0;
  json slides = json::array();
  for (std::size_t e = 0; e < plan.slides.size(); ++e)
    slides.push_back(slide_document(hindcast, e));
  json out{
      {"name", hindcast.asked.name},
      {"condition", hindcast_condition},
      {"members", s.members},
      {"waves", s.waves},
      {"locals", plan.draws.locals},
      {"seed", plan.draws.seed},
      {"confidence", plan.confidence},
      {"discrepancy",
       {{"sd_ln", plan.discrepancy.sd_ln},
        {"correlation", plan.discrepancy.correlation},
        {"bias_sd_ln", plan.discrepancy.bias_sd_ln},
        {"bias_after", {{"mean_ln", s.bias_ln}, {"sd_ln", s.bias_sd_ln}}}}},
      {"weights", weights_document(s)},
      {"shared_inputs", inputs_document(hindcast)},
      {"slides", slides},
      {"posterior", {{"label", posterior_label(hindcast)}, {"inputs", posterior_inputs(hindcast)}}},
      {"warnings", hindcast_warnings(hindcast.asked, hindcast.rows, s.members)},
      {"core_s", core_s}};
  for (const auto& [distance, score] : s.scores) out[to_string(distance)] = score_document(score);
  return out;
}

std::string members_csv(const Hindcast& hindcast) {
  const auto& plan = hindcast.asked.plan;
  std::string text = "slide,wave,member,local,prior_weight,weight";
  for (const auto& input : plan.draws.inputs) text += "," + input.name;
  text +=
      ",seed,status,retrogression_m,retrogression_is,runout_m,runout_is,run_time_s,case_sha256,"
      "version\r\n";
  for (const HindcastRow& row : hindcast.rows) {
    const std::size_t m = row.run.member;
    text += fmt::format("\"{}\",{},{},{},{},{}", hindcast.asked.slide(row.run),
                        m / plan.draws.members + 1, m, row.run.local + 1,
                        hindcast.summary.prior.values[m], hindcast.summary.posterior.values[m]);
    for (const double input : row.inputs) text += fmt::format(",{}", input);
    text += fmt::format(",{},", row.seed);
    if (!row.result) {
      text += "no-result,,,,,,,\r\n";
      continue;
    }
    const SectionResult& r = *row.result;
    text += fmt::format("{},{},{},{},{},{},{},{}\r\n", to_string(r.status),
                        r.crest_to_crest_retrogression_m, to_string(r.retrogression_is), r.runout_m,
                        to_string(r.runout_is), r.run_time_s, r.case_sha256, r.version);
  }
  return text;
}

std::string interval_text(const Prediction& prediction) {
  return prediction.high_m ? fmt::format("{:.1f} to {:.1f}", prediction.low_m, *prediction.high_m)
                           : fmt::format("{:.1f} and more", prediction.low_m);
}

std::string observed_text(const solver::Observed& o) {
  if (o.value_m) return fmt::format("{:g}", *o.value_m);
  if (o.at_least_m && o.at_most_m) return fmt::format("{:g} to {:g}", *o.at_least_m, *o.at_most_m);
  return o.at_least_m ? fmt::format("at least {:g}", *o.at_least_m)
                      : fmt::format("at most {:g}", *o.at_most_m);
}

std::string hindcast_table(const Hindcast& hindcast) {
  const auto& s = hindcast.summary;
  const auto& plan = hindcast.asked.plan;
  std::string text = fmt::format("{} members in {} wave{}, {:.0f} effective", s.members, s.waves,
                                 s.waves == 1 ? "" : "s", s.posterior.effective);
  if (s.posterior.pareto_k) text += fmt::format(", Pareto shape {:.2f}", *s.posterior.pareto_k);
  text += s.doubts.empty() ? "\n" : "; the weights are not to be trusted:\n";
  for (const auto& doubt : s.doubts) text += "  " + doubt + "\n";
  for (const auto& input : s.inputs) {
    text += fmt::format(
        "{:<20}{:.3g} ({:.3g} to {:.3g}), before {:.3g} ({:.3g} to {:.3g}): moved "
        "by {:+.2f} sd, {:.2f} as wide\n",
        plan.draws.inputs[input.input].name, input.posterior.median, input.posterior.low,
        input.posterior.high, input.prior.median, input.prior.low, input.prior.high, input.shift,
        input.narrowing);
  }
  text += slides_text(hindcast);
  for (const auto& [distance, score] : s.scores) {
    text += scores_text(score, to_string(distance), plan.confidence);
  }
  return text + hindcast_condition + "\n" +
         warning_lines(hindcast_warnings(hindcast.asked, hindcast.rows, s.members));
}

}  // namespace leda::server
