#include "solver/hindcast/posterior.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/hindcast/likelihood.hpp"
#include "solver/hindcast/weights.hpp"

namespace leda::solver {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The trapezoidal rule over the normal distribution of the bias, which is exact to many digits
/// where the likelihood is wider than a step.
std::vector<Likelihoods::BiasNode> nodes_of(double sd) {
  if (sd == 0) return {{0, 1}};
  constexpr int steps = 16;
  constexpr double step = 0.25;  // standard deviations
  std::vector<Likelihoods::BiasNode> nodes;
  double sum = 0;
  for (int i = -steps; i <= steps; ++i) {
    const double z = step * i;
    nodes.push_back({sd * z, std::exp(-0.5 * z * z)});
    sum += nodes.back().weight;
  }
  for (auto& node : nodes) node.weight /= sum;
  return nodes;
}

/// ln of the mean likelihood over the local draws that slid.
double mean_over_locals(const PastSlide& slide, const std::vector<MemberOutcome>& locals,
                        const Discrepancy& discrepancy, double bias_ln) {
  std::vector<double> logs;
  for (const MemberOutcome& outcome : locals) {
    if (!outcome.slid().value_or(false)) continue;
    logs.push_back(
        log_likelihood(slide, outcome.retrogression, outcome.runout, discrepancy, bias_ln));
  }
  return logs.empty() ? -infinity : log_sum(logs) - std::log(static_cast<double>(logs.size()));
}

}  // namespace

Weights weights_of(const std::vector<double>& logs) {
  Weights weights;
  weights.values = normalized(logs);
  weights.effective = effective_members(weights.values);
  if (weights.effective > 0) weights.pareto_k = pareto_k(logs);
  return weights;
}

Likelihoods::Likelihoods(const HindcastPlan& plan, const SlideOutcomes& outcomes)
    : nodes_(nodes_of(plan.discrepancy.bias_sd_ln)) {
  for (std::size_t e = 0; e < plan.slides.size(); ++e) {
    std::vector<std::vector<double>> members;
    for (const auto& locals : outcomes[e]) {
      std::vector<double> logs;
      for (const BiasNode& node : nodes_) {
        logs.push_back(mean_over_locals(plan.slides[e], locals, plan.discrepancy, node.ln));
      }
      members.push_back(std::move(logs));
    }
    by_node_.push_back(std::move(members));
  }
}

/// ln of prior times likelihood, by node.
std::vector<double> Likelihoods::over_nodes(std::size_t member,
                                            std::optional<std::size_t> without) const {
  std::vector<double> logs;
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    double sum = std::log(nodes_[j].weight);
    for (std::size_t e = 0; e < by_node_.size(); ++e) {
      if (e != without) sum += by_node_[e][member][j];
    }
    logs.push_back(sum);
  }
  return logs;
}

std::vector<double> Likelihoods::of_members(std::optional<std::size_t> without) const {
  std::vector<double> logs;
  for (std::size_t m = 0; m < by_node_.front().size(); ++m) {
    logs.push_back(log_sum(over_nodes(m, without)));
  }
  return logs;
}

std::vector<Likelihoods::BiasNode> Likelihoods::bias_of(std::size_t member,
                                                        std::optional<std::size_t> without) const {
  std::vector<BiasNode> nodes = nodes_;
  const auto weights = normalized(over_nodes(member, without));
  for (std::size_t j = 0; j < nodes.size(); ++j) nodes[j].weight = weights[j];
  return nodes;
}

std::optional<std::vector<double>> next_wave(const HindcastPlan& plan, const SharedDraws& draws,
                                             const SlideOutcomes& outcomes) {
  if (draws.waves() >= plan.waves) return std::nullopt;
  const auto log_prior = draws.log_prior();
  const auto likelihood = Likelihoods(plan, outcomes).of_members();
  if (log_sum(likelihood) == -infinity) return std::nullopt;
  const auto whole = effective_members(normalized(tempered(log_prior, likelihood, 1)));
  if (whole >= plan.least_effective) return std::nullopt;
  const auto members = static_cast<double>(plan.draws.members);
  const double about = std::min(std::max(6.0, members / 6), plan.least_effective);
  const double t = tempering_exponent(log_prior, likelihood, about);
  return normalized(tempered(log_prior, likelihood, t));
}

}  // namespace leda::solver
