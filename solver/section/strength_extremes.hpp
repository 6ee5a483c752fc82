#pragma once
// Seams and hard bands that a table of strength draws, as layers are drawn by their bottoms.

#include <vector>

#include "solver/section/material.hpp"

namespace leda {

/// From an extreme of a table up to this share of it the strength counts as the extreme's own.
inline constexpr double share_of_extreme = 0.1;

/// A place where the strength of a table is least or largest among its neighbours. All of them are
/// depths or elevations, as the table has them.
struct StrengthExtreme {
  double strength_Pa = 0;
  bool is_dip = true;                 ///< else the strength falls on both sides
  double from = 0, to = 0;            ///< within it the strength is nearly the extreme's
  double core_from = 0, core_to = 0;  ///< within it the strength is the extreme's
};

/// The extremes beyond which the strength differs by more than share_of_extreme on both sides, from
/// the first row on. What stands at the end of a table goes on beyond it and is none.
/// @pre the table has no fault
std::vector<StrengthExtreme> extremes_of(const Strength& strength);

}  // namespace leda
