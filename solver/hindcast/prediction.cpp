#include "solver/hindcast/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "solver/ensemble/summary.hpp"
#include "solver/hindcast/mixture.hpp"
#include "solver/hindcast/weights.hpp"

namespace leda::solver {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double negligible = 1e-7;  ///< of the weight

struct Counted {
  std::size_t slid = 0, known = 0;
};

Counted count(const std::vector<MemberOutcome>& locals) {
  Counted c;
  for (const auto& outcome : locals) {
    const auto slid = outcome.slid();
    if (slid) ++c.known;
    if (slid.value_or(false)) ++c.slid;
  }
  return c;
}

/// Over the runs that gave a result.
double share_that_slides(const std::vector<std::vector<MemberOutcome>>& members,
                         const std::vector<double>& weights) {
  double slid = 0, all = 0;
  for (std::size_t m = 0; m < members.size(); ++m) {
    const Counted c = count(members[m]);
    slid += weights[m] * static_cast<double>(c.slid);
    all += weights[m] * static_cast<double>(c.known);
  }
  return all > 0 ? slid / all : 0;
}

std::map<std::string, std::size_t> count_runs(
    const std::vector<std::vector<MemberOutcome>>& members) {
  std::map<std::string, std::size_t> runs;
  for (const auto& locals : members) {
    for (const MemberOutcome& o : locals) {
      if (!o.slid()) ++runs["no-result"];
      if (o.slid() == false) ++runs["at-rest"];
      if (o.slid() != true) continue;
      ++runs["slid"];
      if (!o.retrogression.is_measured() || !o.runout.is_measured()) ++runs["cut-short"];
    }
  }
  return runs;
}

/// Lognormal by the values measured at the other slides.
std::optional<double> score_of_rule(const HindcastPlan& plan, std::size_t slide,
                                    Distance distance) {
  std::vector<double> others;
  for (std::size_t e = 0; e < plan.slides.size(); ++e) {
    const Observed* o = observed_of(plan.slides[e], distance);
    if (e != slide && o != nullptr && o->value_m) others.push_back(std::log(*o->value_m));
  }
  if (others.size() < 3) return std::nullopt;
  const auto n = static_cast<double>(others.size());
  const double mean = std::accumulate(others.begin(), others.end(), 0.0) / n;
  double squares = 0;
  for (const double one : others) squares += (one - mean) * (one - mean);
  if (!(squares > 0)) return std::nullopt;
  Mixture rule;
  rule.add(1, mean, false);
  rule.close(std::sqrt(squares / (n - 1)));
  return rule.crps(std::log(*observed_of(plan.slides[slide], distance)->value_m));
}

class OneSlide {
 public:
  OneSlide(const HindcastPlan& plan, const std::vector<std::vector<MemberOutcome>>& members,
           const Likelihoods& likelihoods, const Weights& others, std::size_t slide)
      : plan_(plan), members_(members), likelihoods_(likelihoods), others_(others), slide_(slide) {}

  /// @return nothing where no member that slid has a weight
  std::optional<Prediction> of(Distance distance) const {
    const Observed& observed = *observed_of(plan_.slides[slide_], distance);
    const double survey = observed.value_m ? observed.sd_ln : 0;
    Mixture mixture = mixture_of(distance);
    if (mixture.empty()) return std::nullopt;
    mixture.close(std::hypot(plan_.discrepancy.sd_ln, survey));
    Prediction p = interval_of(mixture);
    if (!observed.value_m) return p;
    const double value = *observed.value_m;
    p.hit = value >= p.low_m && (!p.high_m || value <= *p.high_m);
    p.pit = mixture.cdf(std::log(value));
    p.crps_ln = mixture.crps(std::log(value));
    p.crps_of_rule_ln = score_of_rule(plan_, slide_, distance);
    return p;
  }

 private:
  Mixture mixture_of(Distance distance) const {
    Mixture mixture;
    for (std::size_t m = 0; m < members_.size(); ++m) {
      const double weight = others_.values[m];
      if (weight <= negligible) continue;
      const auto slid = static_cast<double>(count(members_[m]).slid);
      for (const auto& bias : likelihoods_.bias_of(m, slide_)) {
        if (bias.weight <= negligible) continue;
        for (const MemberOutcome& outcome : members_[m]) {
          if (!outcome.slid().value_or(false)) continue;
          const Reach& reach = outcome.of(distance);
          const double least = std::max(reach.low_m, plan_.slides[slide_].least_m);
          mixture.add(weight * bias.weight / slid, std::log(least) + bias.ln, !reach.is_measured());
        }
      }
    }
    return mixture;
  }

  Prediction interval_of(const Mixture& mixture) const {
    const double tail = (1 - plan_.confidence) / 2;
    Prediction p;
    p.low_m = std::exp(mixture.quantile(tail));
    p.median_m = std::exp(mixture.quantile(0.5));
    p.beyond = mixture.beyond();
    const auto high = mixture.quantile_at_most(1 - tail);
    if (high) p.high_m = std::exp(*high);
    p.width_ln = high ? *high - std::log(p.low_m) : infinity;
    return p;
  }

  const HindcastPlan& plan_;
  const std::vector<std::vector<MemberOutcome>>& members_;
  const Likelihoods& likelihoods_;
  const Weights& others_;
  std::size_t slide_;
};

}  // namespace

const Observed* observed_of(const PastSlide& slide, Distance distance) {
  const auto& observed = distance == Distance::retrogression ? slide.retrogression : slide.runout;
  return observed ? &*observed : nullptr;
}

SlidePrediction predict(const HindcastPlan& plan, const SlideOutcomes& outcomes,
                        const Likelihoods& likelihoods, const std::vector<double>& log_prior,
                        double exponent, std::size_t slide) {
  const auto& members = outcomes[slide];
  SlidePrediction out;
  out.runs = count_runs(members);
  out.others = weights_of(tempered(log_prior, likelihoods.of_members(slide), exponent));
  out.slides_prior = share_that_slides(members, normalized(log_prior));
  out.slides_from_others = share_that_slides(members, out.others.values);
  const OneSlide one(plan, members, likelihoods, out.others, slide);
  for (const Distance distance : distances) {
    if (observed_of(plan.slides[slide], distance) == nullptr) continue;
    if (auto prediction = one.of(distance)) out.by_distance[distance] = *prediction;
  }
  return out;
}

}  // namespace leda::solver
