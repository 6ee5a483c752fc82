#pragma once
// Ground at rest is not stepped: which groups of columns rest, and when they wake.

#include <cstdint>
#include <vector>

#include "solver/kernel/kernel.hpp"

namespace leda::solver {

/// A group of columns rests once neither it nor a neighbour has yielded or held a point faster than
/// `quiet_speed` for `quiet_time`. It wakes with the first step in which a neighbour does either,
/// or once a neighbour's fastest point may have come `most_drift` of the group's width: the elastic
/// strain the group has missed is below that. So a group that is stepped and quiet always lies
/// between moving and resting ground, and a wave takes at least 24 steps to cross it.
/// Resting nodes have no velocity, resting points keep their stress and push on the nodes beside.
struct GroupRest {
  static constexpr double quiet_speed = 0.02;  ///< m/s; a run is at rest below 0.05 m/s
  static constexpr double quiet_time = 0.5;    ///< s
  static constexpr double most_drift =
      1e-3;  ///< of the width; soft clay yields at a strain of 1e-2

  double quiet = 0;  ///< s since the group last yielded or was fast
  double drift = 0;  ///< m, the most a neighbour's point may have moved since the group rests
  bool rests = false;
};

/// Takes note of a step of dt: `points` holds what the groups that were stepped did in it.
/// @param width of a group, m
/// @return whether a resting group has to wake
bool observe(std::vector<GroupRest>& groups, const std::vector<PointSums>& points, double dt,
             double width);

/// Wakes the groups that must not rest any longer, and lays to rest those that may.
/// @return whether anything changed
bool decide(std::vector<GroupRest>& groups, double width);

}  // namespace leda::solver
