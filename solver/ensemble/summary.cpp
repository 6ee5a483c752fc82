#include "solver/ensemble/summary.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {
namespace {

/// The jackknife of the indices needs groups, also of members that are independent.
constexpr std::size_t groups_of_independent = 8;

std::vector<Reach> reaches_of(const std::vector<Member>& members, Distance distance) {
  std::vector<Reach> reaches;
  reaches.reserve(members.size());
  for (const Member& member : members) reaches.push_back(member.outcome.of(distance));
  return reaches;
}

/// The distance as far as it was followed; nothing where it is unknown.
std::optional<double> known(const MemberOutcome& outcome, Distance distance) {
  const Reach& reach = outcome.of(distance);
  return reach.is_unknown() ? std::nullopt : std::optional(reach.low_m);
}

std::vector<std::optional<double>> known(const std::vector<Member>& members, Distance distance) {
  std::vector<std::optional<double>> values;
  for (const Member& member : members) values.push_back(known(member.outcome, distance));
  return values;
}

std::vector<std::optional<SobolIndex>> indices_of(const EnsemblePlan& plan,
                                                  const std::vector<Member>& members,
                                                  const std::vector<std::optional<double>>& y) {
  const std::size_t groups =
      plan.sampling.replicates > 1 ? plan.sampling.replicates : groups_of_independent;
  std::vector<std::optional<SobolIndex>> indices;
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    std::vector<double> input;
    for (const Member& member : members) input.push_back(member.inputs[i]);
    indices.push_back(first_order_index(input, y, groups));
  }
  return indices;
}

std::vector<IndexBeyond> indices_beyond(const EnsemblePlan& plan,
                                        const std::vector<Member>& members,
                                        const std::vector<std::optional<double>>& y,
                                        const std::vector<ExceedanceQuantile>& quantiles) {
  std::vector<IndexBeyond> beyond;
  for (const ExceedanceQuantile& quantile : quantiles) {
    const double distance = quantile.distance_m.value_or(0);
    const bool told = std::ranges::any_of(
        beyond, [&](const IndexBeyond& other) { return other.distance_m == distance; });
    if (distance <= 0 || told) continue;
    auto indicator = y;
    for (auto& one : indicator) {
      if (one) one = *one > distance ? 1 : 0;
    }
    beyond.push_back({distance, indices_of(plan, members, indicator)});
  }
  return beyond;
}

std::optional<ChanceShare> chance_of(const std::vector<Member>& members, Distance distance) {
  std::vector<std::vector<double>> repeats;
  std::vector<double> all;
  for (const Member& member : members) {
    const auto own = known(member.outcome, distance);
    if (!own) continue;
    all.push_back(*own);
    std::vector<double> runs{*own};
    for (const MemberOutcome& repeat : member.repeats) {
      if (const auto value = known(repeat, distance)) runs.push_back(*value);
    }
    repeats.push_back(std::move(runs));
  }
  return chance_share(repeats, all);
}

std::optional<CellShift> cell_of(const std::vector<Member>& members, Distance distance) {
  std::vector<CellPair> pairs;
  for (const Member& member : members) {
    if (!member.finer) continue;
    const Reach &coarse = member.outcome.of(distance), &fine = member.finer->of(distance);
    if (coarse.is_measured() && fine.is_measured()) pairs.push_back({coarse.low_m, fine.low_m});
  }
  return cell_shift(pairs);
}

DistanceSummary summary_of(const EnsemblePlan& plan, const std::vector<Member>& members,
                           Distance distance) {
  DistanceSummary summary;
  const auto reaches = reaches_of(members, distance);
  summary.curve = exceedance_curve(reaches, plan.replication());
  for (const double exceedance : plan.exceedance) {
    summary.quantiles.push_back(
        exceedance_quantile(reaches, summary.curve, exceedance, plan.replication()));
  }
  const auto y = known(members, distance);
  summary.indices = indices_of(plan, members, y);
  summary.beyond = indices_beyond(plan, members, y, summary.quantiles);
  summary.chance = chance_of(members, distance);
  summary.cell = cell_of(members, distance);
  return summary;
}

double cost_of(const Member& member) {
  double cost = member.outcome.run_time_s;
  for (const MemberOutcome& repeat : member.repeats) cost += repeat.run_time_s;
  return cost + (member.finer ? member.finer->run_time_s : 0);
}

}  // namespace

Replication EnsemblePlan::replication() const {
  const bool independent = sampling.method == Method::random;
  return {independent ? 1 : sampling.replicates, stop.confidence};
}

EnsembleSummary summarize(const EnsemblePlan& plan, const std::vector<Member>& members) {
  EnsembleSummary summary;
  summary.members = members.size();
  summary.half_width = 0;
  for (const Member& member : members) {
    const auto& status = member.outcome.status;
    ++summary.by_status[status ? to_string(*status) : "no-result"];
    summary.core_s += cost_of(member);
  }
  for (const Distance distance : distances) {
    auto of = summary_of(plan, members, distance);
    summary.half_width = std::max(summary.half_width, of.curve.half_width);
    summary.by_distance.emplace(distance, std::move(of));
  }
  // The section slides where its retrogression exceeds 0, the first point of the curve.
  const CurvePoint& at_0 = summary.by_distance.at(Distance::retrogression).curve.points.front();
  summary.probability_of_sliding = at_0.probability;
  summary.sliding = at_0.interval;
  summary.ending = ending(plan.stop, members.size(), summary.half_width);
  return summary;
}

}  // namespace leda::solver
