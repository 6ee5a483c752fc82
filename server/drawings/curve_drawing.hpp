#pragma once
// Stress over strain as a drawing: SVG 1.1, self-contained.

#include <string>
#include <vector>

namespace leda::server {

struct DrawnCurve {
  std::string label;
  std::vector<double> strain;     ///< fraction
  std::vector<double> stress_Pa;  ///< as many
  bool as_points = false;         ///< marks instead of a line
};

/// Two panels of the same curves: strain to scale, and strain by its logarithm, which shows the
/// few percent around the peak and the many hundred of the tail alike.
/// @pre at least one curve with a point
std::string draw_curves(const std::string& title, const std::vector<DrawnCurve>& curves);

}  // namespace leda::server
