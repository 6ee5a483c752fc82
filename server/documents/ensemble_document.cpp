#include "server/documents/ensemble_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "server/documents/or_null.hpp"
#include "server/documents/warning_lines.hpp"
#include "solver/section/gathered_warnings.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::CurvePoint;
using solver::Distance;
using solver::DistanceRange;
using solver::DistanceSummary;
using solver::ExceedanceQuantile;
using solver::SobolIndex;

json to_json(const DistanceRange& range) { return {range.low_m, or_null(range.high_m)}; }

json to_json(const ExceedanceQuantile& q) {
  return {{"exceedance", q.exceedance},
          {"distance_m", or_null(q.distance_m)},
          {"distance_is", !q.distance_m      ? "unknown"
                          : q.is_lower_bound ? "lower-bound"
                                             : "measured"},
          {"text", distance_text(q)},
          {"in_gap", q.in_gap},
          {"by_ranks_m", to_json(q.by_ranks)},
          {"by_replicates_m", to_json(q.by_replicates)}};
}

json to_json(const solver::ExceedanceCurve& curve) {
  json points = json::array(), gaps = json::array();
  for (const CurvePoint& p : curve.points) {
    points.push_back({p.distance_m, p.probability, p.interval.low, p.interval.high});
  }
  for (const auto& gap : curve.gaps) {
    gaps.push_back(
        {{"from_m", gap.from_m}, {"to_m", gap.to_m}, {"probability_beyond", gap.probability}});
  }
  return {{"columns", {"distance_m", "probability_exceeded", "low", "high"}},
          {"points", points},
          {"gaps", gaps},
          {"half_width", curve.half_width},
          {"censored_beyond_m", or_null(curve.censored_beyond_m)}};
}

json to_json(const std::vector<std::optional<SobolIndex>>& indices,
             const std::vector<solver::UncertainInput>& inputs) {
  json out = json::object();
  for (std::size_t i = 0; i < indices.size(); ++i) {
    json& one = out[inputs[i].name];
    if (!indices[i]) continue;
    one = {{"first_order", indices[i]->first_order},
           {"standard_error", indices[i]->standard_error}};
  }
  return out;
}

json to_json(const std::optional<solver::ChanceShare>& chance) {
  if (!chance) return nullptr;
  return {{"members", chance->members},
          {"runs", chance->runs},
          {"standard_deviation_m", chance->sd_m},
          {"share_of_variance", or_null(chance->share)}};
}

json to_json(const std::optional<solver::CellShift>& shift) {
  if (!shift) return nullptr;
  return {{"pairs", shift->pairs},
          {"mean_m", shift->mean_m},
          {"standard_error_m", or_null(shift->standard_error_m)},
          {"both_slid", shift->both_slid},
          {"mean_ln_ratio", or_null(shift->mean_ln_ratio)},
          {"standard_error_ln", or_null(shift->standard_error_ln)},
          {"only_coarse_slid", shift->only_coarse_slid},
          {"only_fine_slid", shift->only_fine_slid}};
}

json to_json(const DistanceSummary& of, const std::vector<solver::UncertainInput>& inputs) {
  json quantiles = json::array(), beyond = json::array();
  for (const auto& q : of.quantiles) quantiles.push_back(to_json(q));
  for (const auto& one : of.beyond) {
    beyond.push_back({{"distance_m", one.distance_m}, {"indices", to_json(one.indices, inputs)}});
  }
  return {{"quantiles", quantiles},
          {"curve", to_json(of.curve)},
          {"indices", to_json(of.indices, inputs)},
          {"indices_beyond", beyond},
          {"chance", to_json(of.chance)},
          {"finer_cell", to_json(of.cell)}};
}

json inputs_document(const EnsembleRequest& asked) {
  json inputs = json::array();
  for (std::size_t i = 0; i < asked.places.size(); ++i) {
    inputs.push_back({{"name", asked.plan.inputs[i].name},
                      {"path", asked.places[i].path},
                      {"apply", to_string(asked.places[i].apply)},
                      {"scope", to_string(asked.plan.inputs[i].scope)}});
  }
  return inputs;
}

std::string range_text(const DistanceRange& range) {
  return range.high_m ? fmt::format("{:.1f} to {:.1f}", range.low_m, *range.high_m)
                      : fmt::format("{:.1f} and more", range.low_m);
}

std::string table_of(const DistanceSummary& of, const char* name,
                     const std::vector<solver::UncertainInput>& inputs) {
  std::string text =
      fmt::format("{:<16}{:>12}  {:<24}{:<24}\n", name, "m", "by ranks m", "by replicates m");
  for (const auto& q : of.quantiles) {
    text += fmt::format("  {:>4.0f} % exceed{:>12}  {:<24}{:<24}{}\n", 100 * q.exceedance,
                        distance_text(q), range_text(q.by_ranks), range_text(q.by_replicates),
                        q.in_gap ? "across a gap" : "");
  }
  text += "  decided by";
  const bool any =
      std::ranges::any_of(of.indices, [](const auto& index) { return index.has_value(); });
  if (!any) text += ": too few members, or no scatter, to tell";
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!of.indices[i]) continue;
    text += fmt::format(" {} {:.2f} \u00b1 {:.2f}", inputs[i].name, of.indices[i]->first_order,
                        of.indices[i]->standard_error);
  }
  if (of.chance && of.chance->share) {
    text += fmt::format(", chance {:.2f} ({:.1f} m)", *of.chance->share, of.chance->sd_m);
  }
  text += "\n";
  if (of.cell && of.cell->standard_error_m) {
    text += fmt::format("  finer cells: {:+.1f} \u00b1 {:.1f} m over {} pairs\n", of.cell->mean_m,
                        *of.cell->standard_error_m, of.cell->pairs);
  }
  return text;
}

std::vector<std::string> all_warnings(const SectionEnsemble& ensemble) {
  auto warnings = ensemble.warnings;
  add_new(warnings, ensemble.member_warnings);
  return warnings;
}

}  // namespace

json to_document(const SectionEnsemble& ensemble) {
  const auto& plan = ensemble.asked.plan;
  const auto& s = ensemble.summary;
  json by_status = json::object();
  for (const auto& [status, count] : s.by_status) by_status[status] = count;
  return {{"section", ensemble.section},
          {"condition", ensemble_condition},
          {"members", s.members},
          {"by_status", by_status},
          {"ended_by", to_string(s.ending)},
          {"half_width", s.half_width},
          {"wanted_half_width", plan.stop.half_width},
          {"confidence", plan.stop.confidence},
          {"sampling",
           {{"method", to_string(plan.sampling.method)},
            {"seed", plan.sampling.seed},
            {"replicates", plan.sampling.replicates}}},
          {"inputs", inputs_document(ensemble.asked)},
          {"probability_of_sliding",
           {{"value", s.probability_of_sliding}, {"low", s.sliding.low}, {"high", s.sliding.high}}},
          {"retrogression", to_json(s.by_distance.at(Distance::retrogression), plan.inputs)},
          {"runout", to_json(s.by_distance.at(Distance::runout), plan.inputs)},
          {"warnings", all_warnings(ensemble)},
          {"core_s", s.core_s}};
}

namespace {

json difference(const ExceedanceQuantile& from, const ExceedanceQuantile& to) {
  const bool known = from.distance_m && to.distance_m && !from.is_lower_bound && !to.is_lower_bound;
  return known ? json(*to.distance_m - *from.distance_m) : json();
}

json difference(const SectionEnsemble& from, const SectionEnsemble& to) {
  json quantiles = json::array();
  const auto& of_from = from.summary.by_distance;
  const auto& of_to = to.summary.by_distance;
  for (std::size_t i = 0; i < from.asked.plan.exceedance.size(); ++i) {
    const auto of = [&](Distance distance) {
      return difference(of_from.at(distance).quantiles[i], of_to.at(distance).quantiles[i]);
    };
    quantiles.push_back({{"exceedance", from.asked.plan.exceedance[i]},
                         {"retrogression_m", of(Distance::retrogression)},
                         {"runout_m", of(Distance::runout)}});
  }
  return {{"from", from.section},
          {"to", to.section},
          {"probability_of_sliding",
           to.summary.probability_of_sliding - from.summary.probability_of_sliding},
          {"quantiles", quantiles}};
}

}  // namespace

json compare_ensembles(const std::vector<SectionEnsemble>& ensembles) {
  json sections = json::array(), differences = json::array();
  for (const SectionEnsemble& ensemble : ensembles) sections.push_back(to_document(ensemble));
  for (std::size_t i = 1; i < ensembles.size(); ++i) {
    differences.push_back(difference(ensembles[0], ensembles[i]));
  }
  return {{"condition", ensemble_condition}, {"sections", sections}, {"differences", differences}};
}

std::string distance_text(const ExceedanceQuantile& quantile) {
  if (!quantile.distance_m) return "-";
  return fmt::format("{}{:.1f}", quantile.is_lower_bound ? ">" : "", *quantile.distance_m);
}

std::string ensemble_table(const SectionEnsemble& ensemble) {
  const auto& s = ensemble.summary;
  std::string text = fmt::format("{} members", s.members);
  for (const auto& [status, count] : s.by_status) text += fmt::format(", {} {}", count, status);
  text += fmt::format("; ended by {} (curves known to {:.3f}), {:.0f} core-seconds\n",
                      to_string(s.ending), s.half_width, s.core_s);
  text += fmt::format("slides with probability {:.2f} ({:.2f} to {:.2f}), {}\n",
                      s.probability_of_sliding, s.sliding.low, s.sliding.high, ensemble_condition);
  for (const Distance distance : solver::distances) {
    text += table_of(s.by_distance.at(distance), to_string(distance), ensemble.asked.plan.inputs);
  }
  return text + warning_lines(all_warnings(ensemble));
}

std::string quantile_table(const std::vector<SectionEnsemble>& ensembles) {
  if (ensembles.empty()) return "";
  const auto& of_first = ensembles[0].summary.by_distance.at(Distance::retrogression).quantiles;
  std::string text = fmt::format("retrogression/m that members go beyond, {}\n{:<12} {:>7} {:>7}",
                                 ensemble_condition, "section", "members", "slides");
  for (const auto& q : of_first)
    text += fmt::format(" {:>8}", fmt::format("{:g} %", 100 * q.exceedance));
  text += "\n";
  GatheredWarnings of_members;
  for (const SectionEnsemble& ensemble : ensembles) {
    const auto& s = ensemble.summary;
    of_members.add(ensemble.section, ensemble.member_warnings);
    text += fmt::format("{:<12} {:>7} {:>5.0f} %", ensemble.section, s.members,
                        100 * s.probability_of_sliding);
    for (const auto& q : s.by_distance.at(Distance::retrogression).quantiles) {
      text += fmt::format(" {:>8}", distance_text(q));
    }
    text += "\n";
  }
  return text + warning_lines(lines_of(of_members));
}

}  // namespace leda::server
