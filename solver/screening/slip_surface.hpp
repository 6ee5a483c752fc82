#pragma once
// A trial slip surface and its slices.

#include <optional>
#include <vector>

#include "solver/screening/slope_model.hpp"

namespace leda::solver {

/// An arc through two points of the ground, cut off below by the bottom of a layer.
struct TrialSurface {
  Point left, right;      ///< on the ground
  double half_angle = 0;  ///< half the angle of the arc at its centre, rad, 0 to pi/2
  std::size_t floor = 0;  ///< index of the stratum whose bottom is not passed; the last: the base
};

struct Arc {
  Point centre;
  double radius = 0;
};

/// The arc that sags below the chord from left to right.
Arc arc_of(const TrialSurface& surface);

/// Forces and lengths per metre of width. The order is from the upper to the lower end, x counts
/// in the direction of sliding, base angles are positive where weight drives.
struct Slice {
  double width = 0, length = 0;  ///< m
  double sin_a = 0, cos_a = 1;   ///< of the base
  double weight = 0;             ///< N/m
  Resistance resistance;
  double weight_arm = 0;  ///< of the weight about the centre, positive: drives, m
  double shear_arm = 0;   ///< of the base shear about the centre, m
  double normal_arm = 0;  ///< of the base normal about the centre, positive: drives, m
};

/// Cuts the ground above a surface into slices; vertical faces fall on an edge.
/// @param slices taken over as storage
/// @return false where the surface is not admissible: it leaves the ground, or has no fall
bool cut_into_slices(const SlopeModel& model, const TrialSurface& surface, int count,
                     std::vector<Slice>& slices);

/// The line of a surface, left to right.
Polyline line_of(const SlopeModel& model, const TrialSurface& surface, int points);

}  // namespace leda::solver
