#include "solver/screening/bishop.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace leda::solver {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
/// Below this cos a + sin a tan phi / F the normal force grows without meaning (Whitman and
/// Bailey 1967).
constexpr double least_m_alpha = 0.2;

struct Sums {
  double resisting = 0;
  double driving = 0;
};

/// One pass at an assumed factor; resisting is negative where the method fails.
Sums sum_moments(const std::vector<Slice>& slices, double factor) {
  Sums sums;
  for (const Slice& s : slices) {
    const Resistance& r = s.resistance;
    const double m_alpha = s.cos_a + s.sin_a * r.tan_phi / factor;
    if (r.tan_phi > 0 && m_alpha < least_m_alpha) return {-1, 1};
    const double constant = (r.cohesion - r.pore_pressure * r.tan_phi) * s.length;
    const double normal = (s.weight - constant * s.sin_a / factor) / m_alpha;
    // Ground does not hold together by friction: an effective normal force below zero gives none.
    const double friction = (normal - r.pore_pressure * s.length) * r.tan_phi;
    sums.resisting += (r.cohesion * s.length + std::max(0.0, friction)) * s.shear_arm;
    sums.driving += s.weight * s.weight_arm + normal * s.normal_arm;
  }
  return sums;
}

}  // namespace

bool is_frictionless_arc(const std::vector<Slice>& slices) {
  return std::ranges::all_of(slices, [](const Slice& s) {
    return s.resistance.tan_phi <= 0 && std::abs(s.normal_arm) <= 1e-9 * s.shear_arm;
  });
}

double bishop(const std::vector<Slice>& slices) {
  double factor = 1;
  const int passes = is_frictionless_arc(slices) ? 1 : 40;
  for (int pass = 0; pass < passes; ++pass) {
    const auto [resisting, driving] = sum_moments(slices, factor);
    if (!(driving > 0) || !(resisting > 0)) return none;
    const double next = resisting / driving;
    const bool settled = std::abs(next - factor) < 1e-6 * next;
    factor = next;
    if (settled) break;
  }
  return factor;
}

}  // namespace leda::solver
