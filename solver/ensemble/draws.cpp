#include "solver/ensemble/draws.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace leda::solver {
namespace {

std::vector<std::size_t> by_scope(const std::vector<UncertainInput>& inputs) {
  std::vector<std::size_t> order(inputs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return inputs[a].scope < inputs[b].scope; });
  return order;
}

std::vector<RankCorrelation> in_order(std::vector<RankCorrelation> correlations,
                                      const std::vector<std::size_t>& order) {
  const auto place_of = [&](std::size_t input) {
    return static_cast<std::size_t>(std::ranges::find(order, input) - order.begin());
  };
  for (RankCorrelation& c : correlations) {
    c.first = place_of(c.first);
    c.second = place_of(c.second);
  }
  return correlations;
}

/// Columns of one table share their draw, others have one of their own.
std::string name_of_draw(const UncertainInput& input) {
  const auto* joint = std::get_if<JointSample>(&input.distribution);
  return joint != nullptr ? "table " + joint->set : "input " + input.name;
}

}  // namespace

const char* to_string(Scope scope) {
  switch (scope) {
    case Scope::region:
      return "region";
    case Scope::soil:
      return "soil";
    case Scope::section:
      return "section";
  }
  return "";
}

std::optional<Scope> scope_from(const std::string& text) {
  for (const Scope scope : {Scope::region, Scope::soil, Scope::section}) {
    if (text == to_string(scope)) return scope;
  }
  return std::nullopt;
}

std::optional<Draws> Draws::make(std::vector<UncertainInput> inputs,
                                 const std::vector<RankCorrelation>& correlations,
                                 const Sampling& sampling, std::size_t first_members,
                                 std::size_t most_members) {
  auto order = by_scope(inputs);
  auto copula = Copula::make(inputs.size(), in_order(correlations, order));
  if (!copula) return std::nullopt;
  Design design(sampling, inputs.size(), first_members, most_members);
  return Draws(std::move(inputs), std::move(order), std::move(*copula), sampling,
               std::move(design));
}

Draws::Draws(std::vector<UncertainInput> inputs, std::vector<std::size_t> order, Copula copula,
             const Sampling& sampling, Design design)
    : inputs_(std::move(inputs)),
      order_(std::move(order)),
      copula_(std::move(copula)),
      seed_(sampling.seed),
      design_(std::move(design)) {}

Key Draws::key_of(Scope scope, const Place& place) const {
  const Key key = seed_.with(to_string(scope));
  if (scope == Scope::region) return key;
  return key.with(scope == Scope::soil ? place.soil : place.section);
}

std::vector<double> Draws::inputs_of(const Place& place, std::size_t member) const {
  return values_at(coordinates_of(place, member));
}

std::size_t Draws::coordinate_of(std::size_t input) const {
  const std::string name = name_of_draw(inputs_[input]);
  const auto same =
      std::ranges::find_if(inputs_, [&](const auto& other) { return name_of_draw(other) == name; });
  return static_cast<std::size_t>(same - inputs_.begin());
}

std::vector<double> Draws::coordinates_of(const Place& place, std::size_t member) const {
  std::vector<double> u;
  u.reserve(inputs_.size());
  for (std::size_t i = 0; i < inputs_.size(); ++i) {
    const Key key = key_of(inputs_[i].scope, place).with(name_of_draw(inputs_[i]));
    u.push_back(design_.coordinate(coordinate_of(i), member, key));
  }
  return u;
}

std::vector<double> Draws::values_at(const std::vector<double>& coordinates) const {
  std::vector<double> u;
  u.reserve(order_.size());
  for (const std::size_t i : order_) u.push_back(coordinates[i]);
  const auto correlated = copula_(u);
  std::vector<double> values(inputs_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) {
    values[order_[k]] = quantile(inputs_[order_[k]].distribution, correlated[k]);
  }
  return values;
}

std::uint64_t Draws::particle_seed(const Place& place, std::size_t member,
                                   std::size_t repeat) const {
  const Key key = key_of(Scope::section, place).with("particles").with(member).with(repeat);
  return (key.bits() >> 33U) + 1;
}

}  // namespace leda::solver
