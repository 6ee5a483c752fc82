#pragma once
// Where a stress beyond the surface returns to, found another way than the kernel does: Tresca, or
// Mohr and Coulomb without dilation, with a tension cut-off.

#include <algorithm>
#include <array>

namespace leda::solver::test {

struct YieldBody {
  double shear;    ///< s: differences of principal stresses are at most 2 s, Pa
  double tension;  ///< T: principal stresses are at most T, Pa
  /// Of ground that drains: `shear` is c' cos(phi'), and differences are at most
  /// 2 (c' cos(phi') - (mean of the two + u) sin(phi')).
  double sin_friction = 0;
  double pore_pressure = 0;  ///< u, Pa
};

/// Of all sets of active constraints with multipliers that are not negative the one whose point
/// violates none of the others (Karush, Kuhn and Tucker): for a convex body there is one point, the
/// closest one in the elastic metric. Friction acts without dilation: shear returns along the
/// difference of two principal stresses whatever the surface's normal.
/// @param trial principal stresses in any order  @param g, lame elastic constants, Pa
std::array<double, 3> closest_point(const std::array<double, 3>& trial, const YieldBody& body,
                                    double g, double lame);

/// Principal stresses to compare whatever their order.
inline std::array<double, 3> sorted(std::array<double, 3> s) {
  std::ranges::sort(s);
  return s;
}

}  // namespace leda::solver::test
