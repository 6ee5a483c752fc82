#pragma once
// The closest point, in the elastic metric, of the body of stresses that Tresca and a tension
// cut-off allow, found another way than the kernel does.

#include <array>

namespace leda::solver::test {

struct YieldBody {
  double shear;    ///< s: differences of principal stresses are at most 2 s, Pa
  double tension;  ///< T: principal stresses are at most T, Pa
};

/// Of all sets of active constraints with multipliers that are not negative the one whose point
/// violates none of the others (Karush, Kuhn and Tucker): for a convex body there is one point.
/// @param trial principal stresses in any order  @param g, lame elastic constants, Pa
std::array<double, 3> closest_point(const std::array<double, 3>& trial, const YieldBody& body,
                                    double g, double lame);

}  // namespace leda::solver::test
