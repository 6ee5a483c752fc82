#include "solver/screening/limit_equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/screening/critical_surface.hpp"

namespace leda::solver {
namespace {

/// Neighbourhoods of the coarse grid that are searched further.
constexpr std::size_t starts = 5;

std::string undrained_only(const Section& section) {
  for (const Layer& layer : section.layers) {
    if (!section.materials.at(layer.material).drained) {
      return "material " + layer.material + " has no drained strength";
    }
  }
  return {};
}

std::optional<double> least(const SlopeModel& model, const GroundPath& path,
                            const std::vector<FoundSurface>& from, Method method) {
  double factor = std::numeric_limits<double>::infinity();
  for (const FoundSurface& start : from) {
    factor = std::min(factor, refine(model, path, start, method).factor);
  }
  if (!std::isfinite(factor)) return std::nullopt;
  return factor;
}

CriticalSurface describe(const SlopeModel& model, const GroundPath& path,
                         const FoundSurface& found) {
  const TrialSurface surface = surface_of(path, found.at);
  const Arc arc = arc_of(surface);
  CriticalSurface result{line_of(model, surface, 61), arc.centre, arc.radius, false};
  result.composite = std::ranges::any_of(result.line, [&](const Point& p) {
    return std::hypot(p.x - arc.centre.x, p.z - arc.centre.z) < 0.999 * arc.radius;
  });
  return result;
}

}  // namespace

FactorsOfSafety factors_of_safety(const Section& section, const Polyline& ground,
                                  Drainage drainage) {
  FactorsOfSafety factors;
  if (drainage == Drainage::drained) factors.why_not = undrained_only(section);
  if (!factors.why_not.empty()) return factors;
  const SlopeModel model(section, ground, drainage);
  const GroundPath path(ground);
  const std::vector<FoundSurface> found = find_critical_surfaces(model, path, starts);
  if (found.empty()) {
    factors.why_not = "no slip surface: the ground has no slope";
    return factors;
  }
  const std::vector<FoundSurface> best(
      found.begin(), found.begin() + std::min<std::ptrdiff_t>(3, std::ssize(found)));
  factors.bishop = found.front().factor;
  factors.spencer = least(model, path, best, Method::spencer);
  factors.morgenstern_price = least(model, path, best, Method::morgenstern_price);
  factors.surface = describe(model, path, found.front());
  return factors;
}

std::optional<double> undrained_bishop(const Section& section, const Polyline& ground) {
  const SlopeModel model(section, ground, Drainage::undrained);
  const std::vector<FoundSurface> found = find_critical_surfaces(model, GroundPath(ground), starts);
  if (found.empty()) return std::nullopt;
  return found.front().factor;
}

double infinite_slope_undrained(double strength_Pa, double unit_weight, double depth_m,
                                double slope_rad) {
  return strength_Pa / (unit_weight * depth_m * std::sin(slope_rad) * std::cos(slope_rad));
}

}  // namespace leda::solver
