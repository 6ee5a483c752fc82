#pragma once
// The one form that every softening law of the thesis takes: exponential, then linear, then flat.
// The inner loop knows this form only; each law says which curve it is.

#include <algorithm>
#include <cmath>

namespace leda::solver {

/// Strength over accumulated plastic engineering shear strain (fraction), Pa:
///   gamma <= exp_end             : min(peak, floor + amplitude exp(-rate gamma))
///   exp_end < gamma < line_end   : straight from line_start (at exp_end) to last (at line_end)
///   gamma >= line_end            : last
struct SofteningCurve {
  double peak = 0;
  double floor = 0;
  double amplitude = 0;
  double rate = 0;
  double exp_end = 0;
  double line_start = 0;
  double line_end = 0;  ///< >= exp_end
  double last = 0;
};

inline double strength(const SofteningCurve& c, double gamma) {
  if (gamma <= c.exp_end) {
    return std::min(c.peak, c.floor + c.amplitude * std::exp(-c.rate * gamma));
  }
  if (gamma >= c.line_end) return c.last;
  return c.line_start + (c.last - c.line_start) * (gamma - c.exp_end) / (c.line_end - c.exp_end);
}

}  // namespace leda::solver
