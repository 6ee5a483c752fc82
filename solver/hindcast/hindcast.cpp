#include "solver/hindcast/hindcast.hpp"

#include <algorithm>
#include <cmath>

#include "solver/ensemble/summary.hpp"
#include "solver/hindcast/weights.hpp"

namespace leda::solver {
namespace {

/// More of the weight on members of unknown reach than this is told as a doubt.
constexpr double much = 0.1;

std::string two_digits(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.find('.') + 3);
}

/// Of a distance that was observed.
bool is_cut_short(const PastSlide& slide, const MemberOutcome& outcome) {
  if (!outcome.slid().value_or(false)) return false;
  return (slide.retrogression && !outcome.retrogression.is_measured()) ||
         (slide.runout && !outcome.runout.is_measured());
}

double share_cut_short(const HindcastPlan& plan, const SlideOutcomes& outcomes,
                       const std::vector<double>& weights) {
  double share = 0;
  for (std::size_t m = 0; m < weights.size(); ++m) {
    bool cut = false;
    for (std::size_t e = 0; e < plan.slides.size(); ++e) {
      for (const MemberOutcome& outcome : outcomes[e][m]) {
        cut = cut || is_cut_short(plan.slides[e], outcome);
      }
    }
    if (cut) share += weights[m];
  }
  return share;
}

void set_bias(HindcastSummary& summary, const Likelihoods& likelihoods) {
  double mean = 0, square = 0;
  for (std::size_t m = 0; m < summary.members; ++m) {
    const double weight = summary.posterior.values[m];
    if (!(weight > 0)) continue;
    for (const auto& node : likelihoods.bias_of(m)) {
      mean += weight * node.weight * node.ln;
      square += weight * node.weight * node.ln * node.ln;
    }
  }
  summary.bias_ln = mean;
  summary.bias_sd_ln = std::sqrt(std::max(square - mean * mean, 0.0));
}

std::vector<InputShift> shifts_of(const HindcastPlan& plan, const SharedDraws& draws,
                                  const HindcastSummary& summary) {
  std::vector<InputShift> shifts;
  for (std::size_t i = 0; i < plan.draws.inputs.size(); ++i) {
    if (plan.draws.inputs[i].scope != Scope::region) continue;
    std::vector<double> values;
    for (std::size_t m = 0; m < summary.members; ++m) {
      values.push_back(draws.inputs_of({0, m, 0}, plan.slides.front().name)[i]);
    }
    shifts.push_back(
        shift_of(values, summary.prior.values, summary.posterior.values, plan.confidence));
    shifts.back().input = i;
  }
  return shifts;
}

std::optional<double> median_width(std::vector<double> widths) {
  if (widths.empty()) return std::nullopt;
  std::ranges::sort(widths);
  const std::size_t half = widths.size() / 2;
  const double upper = widths[half];
  const double median = widths.size() % 2 == 1 ? upper : 0.5 * (widths[half - 1] + upper);
  return std::isfinite(median) ? std::optional(std::exp(median)) : std::nullopt;
}

std::optional<double> mean_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  double sum = 0;
  for (const double one : values) sum += one;
  return sum / static_cast<double>(values.size());
}

DistanceScore score_of(const std::vector<SlidePrediction>& slides, Distance distance,
                       double confidence) {
  std::vector<double> widths, scores, rule;
  std::size_t hits = 0, measured = 0;
  for (const SlidePrediction& slide : slides) {
    const auto found = slide.by_distance.find(distance);
    if (found == slide.by_distance.end()) continue;
    const Prediction& p = found->second;
    widths.push_back(p.width_ln);
    if (!p.hit) continue;
    ++measured;
    if (*p.hit) ++hits;
    scores.push_back(*p.crps_ln);
    if (p.crps_of_rule_ln) rule.push_back(*p.crps_of_rule_ln);
  }
  DistanceScore score{
      coverage(hits, measured, confidence), median_width(widths), mean_of(scores), {}};
  if (rule.size() == scores.size()) score.mean_crps_of_rule_ln = mean_of(rule);
  return score;
}

std::vector<std::string> doubts_of(const HindcastPlan& plan, const HindcastSummary& s) {
  std::vector<std::string> doubts;
  if (s.full.effective == 0) {
    doubts.emplace_back("no member slid at every past slide and gave a result there");
    return doubts;
  }
  if (s.exponent < 1) {
    doubts.push_back("with the whole likelihood " + two_digits(s.full.effective) +
                     " members are effective, fewer than " + two_digits(plan.least_effective) +
                     ": it counts by the power " + two_digits(s.exponent) +
                     ", which leaves the inputs wider than the slides would have them");
  }
  const double good = largest_good_k(s.members);
  if (s.posterior.pareto_k && *s.posterior.pareto_k >= good) {
    doubts.push_back("the largest weights have a Pareto shape of " +
                     two_digits(*s.posterior.pareto_k) + ", which must be below " +
                     two_digits(good));
  }
  if (s.cut_short > much) {
    doubts.push_back("members with a run that the model's edge or the time limit cut short have " +
                     two_digits(100 * s.cut_short) +
                     " % of the weight: they count at the distance nearest to what was observed");
  }
  for (std::size_t e = 0; e < s.slides.size(); ++e) {
    if (s.slides[e].by_distance.empty()) {
      doubts.push_back("no member that agrees with the other slides slid at " +
                       plan.slides[e].name);
    }
  }
  return doubts;
}

}  // namespace

HindcastSummary summarize(const HindcastPlan& plan, const SharedDraws& draws,
                          const SlideOutcomes& outcomes) {
  const auto log_prior = draws.log_prior();
  const Likelihoods likelihoods(plan, outcomes);
  const auto log_likelihood = likelihoods.of_members();
  HindcastSummary s;
  s.members = draws.members();
  s.waves = draws.waves();
  s.prior = weights_of(log_prior);
  s.full = weights_of(tempered(log_prior, log_likelihood, 1));
  s.exponent = tempering_exponent(log_prior, log_likelihood, plan.least_effective);
  s.posterior = weights_of(tempered(log_prior, log_likelihood, s.exponent));
  s.cut_short = share_cut_short(plan, outcomes, s.posterior.values);
  set_bias(s, likelihoods);
  if (s.posterior.effective > 0) s.inputs = shifts_of(plan, draws, s);
  for (std::size_t e = 0; e < plan.slides.size(); ++e) {
    s.slides.push_back(predict(plan, outcomes, likelihoods, log_prior, s.exponent, e));
  }
  for (const Distance distance : distances) {
    const bool any = std::ranges::any_of(plan.slides, [&](const PastSlide& slide) {
      return observed_of(slide, distance) != nullptr;
    });
    if (any) s.scores[distance] = score_of(s.slides, distance, plan.confidence);
  }
  s.doubts = doubts_of(plan, s);
  return s;
}

}  // namespace leda::solver
