#pragma once
// Factors of safety of a section by limit equilibrium, each with a search for its critical surface.

#include <optional>
#include <string>

#include "solver/section/geometry.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

enum class Drainage { drained, undrained };

/// Where the smallest factor was found: an arc, cut off below where it is composite.
struct CriticalSurface {
  Polyline line;  ///< left to right, both ends on the ground
  Point centre;
  double radius_m = 0;
  bool composite = false;  ///< follows the base or the bottom of a layer
};

/// Absent factors: `why_not` says why (no slope, or no drained strength).
struct FactorsOfSafety {
  std::optional<double> bishop;
  std::optional<double> spencer;
  std::optional<double> morgenstern_price;  ///< half-sine interslice function
  std::optional<CriticalSurface> surface;   ///< of Bishop
  std::string why_not;
};

/// Bishop simplified (1955), Spencer (1967) and Morgenstern-Price (1965), sliding either way.
/// Undrained: s_u = s_up, phi = 0, no free water on the ground. Drained: Material.drained with
/// the pore pressure of the water table.
/// @param ground the surface as it is: the section's own, or what a cut left of it; layers,
/// strengths over depth and water keep to the section's own ground
/// @pre the section is valid
FactorsOfSafety factors_of_safety(const Section& section, const Polyline& ground,
                                  Drainage drainage);

/// Bishop alone, undrained: what every section of a region pays. Absent: nothing slopes.
std::optional<double> undrained_bishop(const Section& section, const Polyline& ground);

/// F = s_u / (gamma z sin b cos b), phi = 0: an endless slope failing at depth z.
double infinite_slope_undrained(double strength_Pa, double unit_weight, double depth_m,
                                double slope_rad);

}  // namespace leda::solver
