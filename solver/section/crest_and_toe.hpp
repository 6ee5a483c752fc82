#pragma once
// The crest and the toe of a bank, by one documented rule.

#include <optional>

#include "solver/section/geometry.hpp"

namespace leda {

struct CrestAndToe {
  Point crest;
  Point toe;
};

/// The side a bank descends to.
enum class Facing { either, right, left };

/// Finds the bank of a ground line that would slide: see crest_and_toe.cpp for the rule.
/// @param ground left to right, at least two points, m
/// @return nothing where the ground has no bank of at least `least_height_m`
std::optional<CrestAndToe> find_crest_and_toe(const Polyline& ground, double least_height_m = 2.0,
                                              Facing facing = Facing::either);

/// Whether a bank descends to the right. Where its crest and its toe stand at one x, the face is
/// vertical and the ground on its two sides tells.
bool falls_right(const Polyline& ground, const CrestAndToe& bank);

}  // namespace leda
