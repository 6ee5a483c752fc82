#include "solver/kernel/rest.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

namespace {

// Calls one(group) for the neighbours of group g; true if any call was.
template <class One>
bool any_neighbour(const std::vector<GroupRest>& groups, std::size_t g, const One& one) {
  return (g > 0 && one(g - 1)) || (g + 1 < groups.size() && one(g + 1));
}

bool has_to_wake(const std::vector<GroupRest>& groups, std::size_t g, double width) {
  return groups[g].drift > GroupRest::most_drift * width ||
         any_neighbour(groups, g,
                       [&](std::size_t n) { return !groups[n].rests && groups[n].quiet == 0; });
}

bool may_rest(const std::vector<GroupRest>& groups, std::size_t g) {
  const auto is_quiet = [&](std::size_t n) {
    return groups[n].rests || groups[n].quiet >= GroupRest::quiet_time;
  };
  return is_quiet(g) && !any_neighbour(groups, g, [&](std::size_t n) { return !is_quiet(n); });
}

}  // namespace

bool observe(std::vector<GroupRest>& groups, const std::vector<PointSums>& points, double dt,
             double width) {
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (groups[g].rests) continue;
    const double speed = std::sqrt(points[g].fastest_squared);
    const bool quiet = speed < GroupRest::quiet_speed && !points[g].yields;
    groups[g].quiet = quiet ? groups[g].quiet + dt : 0.0;
  }
  bool wakes = false;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!groups[g].rests) continue;
    double fastest_squared = 0;
    any_neighbour(groups, g, [&](std::size_t n) {
      fastest_squared = std::max(fastest_squared, points[n].fastest_squared);
      return false;
    });
    groups[g].drift += std::sqrt(fastest_squared) * dt;
    wakes = wakes || has_to_wake(groups, g, width);
  }
  return wakes;
}

bool decide(std::vector<GroupRest>& groups, double width) {
  std::vector<GroupRest> next = groups;
  bool changed = false;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const bool rests = groups[g].rests ? !has_to_wake(groups, g, width) : may_rest(groups, g);
    if (rests == groups[g].rests) continue;
    next[g] = GroupRest{0, 0, rests};
    changed = true;
  }
  groups = std::move(next);
  return changed;
}

}  // namespace leda::solver
