#include "solver/hindcast/shared_draws.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <utility>

#include "solver/hindcast/weights.hpp"

namespace leda::solver {
namespace {

double score_of(double u) { return boost::math::quantile(boost::math::normal(), u); }

/// Never 0 or 1, however far out.
double coordinate_at(double score) {
  const double u = boost::math::cdf(boost::math::normal(), score);
  return std::clamp(u, 0x1p-54, 1 - 0x1p-53);
}

}  // namespace

SharedDraws::SharedDraws(SharedPlan plan) : plan_(std::move(plan)) {
  waves_.push_back(wave_of(0));
  for (std::size_t i = 0; i < plan_.inputs.size(); ++i) {
    const bool shared = plan_.inputs[i].scope == Scope::region;
    if (shared && waves_.front().front().coordinate_of(i) == i) coordinates_.push_back(i);
  }
  for (std::size_t m = 0; m < plan_.members; ++m) scores_.push_back(scores_of_first_wave(m));
}

SharedDraws::Wave SharedDraws::wave_of(std::size_t wave) const {
  const Key key = Key(plan_.seed).with("wave").with(wave);
  Wave draws;
  for (std::size_t local = 0; local < plan_.locals; ++local) {
    const Sampling sampling{Method::latin, key.with("local").with(local).bits(), 1};
    draws.push_back(
        Draws::make(plan_.inputs, plan_.correlations, sampling, plan_.members, plan_.members)
            .value());
  }
  return draws;
}

Scores SharedDraws::scores_of_first_wave(std::size_t member) const {
  const auto u = waves_.front().front().coordinates_of({}, member);
  Scores scores;
  for (const std::size_t i : coordinates_) scores.push_back(score_of(u[i]));
  return scores;
}

void SharedDraws::add_wave(const std::vector<double>& weights) {
  proposals_.emplace_back(scores_, weights);
  const std::size_t wave = waves_.size();
  waves_.push_back(wave_of(wave));
  const Key key = Key(plan_.seed).with("wave").with(wave);
  const double first = key.with("first").uniform();
  for (std::size_t m = 0; m < plan_.members; ++m) {
    const Key own = key.with("member").with(m);
    Scores normals;
    for (std::size_t i = 0; i < coordinates_.size(); ++i) {
      normals.push_back(score_of(own.with(i).uniform()));
    }
    // In equal steps through the weights: chance chooses their beginning alone.
    const double which = (static_cast<double>(m) + first) / static_cast<double>(plan_.members);
    scores_.push_back(proposals_.back().draw(which, normals));
  }
}

std::vector<double> SharedDraws::log_prior() const {
  std::vector<double> logs;
  const double share = -std::log(static_cast<double>(waves_.size()));
  for (const Scores& point : scores_) {
    const double prior = log_standard_normal(point);
    std::vector<double> drawn{share + prior};
    for (const Proposal& proposal : proposals_) {
      drawn.push_back(share + proposal.log_density(point));
    }
    logs.push_back(prior - log_sum(drawn));
  }
  return logs;
}

std::vector<double> SharedDraws::inputs_of(const HindcastRun& run, const std::string& slide) const {
  const std::size_t in_wave = run.member % plan_.members;
  const Draws& local = waves_.at(run.member / plan_.members).at(run.local);
  auto u = local.coordinates_of({slide, slide}, in_wave);
  const Scores& scores = scores_.at(run.member);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto own = std::ranges::find(coordinates_, local.coordinate_of(i));
    if (own == coordinates_.end()) continue;
    u[i] = coordinate_at(scores[static_cast<std::size_t>(own - coordinates_.begin())]);
  }
  return local.values_at(u);
}

std::uint64_t SharedDraws::particle_seed(const HindcastRun& run, const std::string& slide) const {
  const std::size_t in_wave = run.member % plan_.members;
  return waves_.at(run.member / plan_.members).at(run.local).particle_seed({slide, slide}, in_wave);
}

}  // namespace leda::solver
