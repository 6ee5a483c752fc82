#include "solver/screening/limit_equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "solver/screening/critical_surface.hpp"

namespace leda::solver {
namespace {

/// Neighbourhoods of the coarse grid that are searched further.
constexpr std::size_t starts = 5;
constexpr std::size_t starts_of_other_methods = 3;

/// Empty where every material has one.
std::string missing_drained_strength(const Section& section) {
  for (std::size_t list = 0; list < layer_lists(section); ++list) {
    for (const Layer& layer : layers_of(section, list)) {
      if (!section.materials.at(layer.material).drained) {
        return "material " + layer.material + " has no drained strength";
      }
    }
  }
  return {};
}

std::optional<double> least(const SlopeModel& model, const GroundPath& path,
                            const std::vector<FoundSurface>& grid, Method method) {
  const auto found = find_critical_surfaces(model, path, grid, method, starts_of_other_methods);
  if (found.empty()) return std::nullopt;
  return found.front().factor;
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
  if (drainage == Drainage::drained) factors.why_not = missing_drained_strength(section);
  if (!factors.why_not.empty()) return factors;
  const SlopeModel model(section, ground, drainage);
  const GroundPath path(ground);
  const std::vector<FoundSurface> grid = surface_grid(model, path);
  const auto found = find_critical_surfaces(model, path, grid, Method::bishop, starts);
  if (found.empty()) {
    factors.why_not = "no slip surface: the ground has no slope";
    return factors;
  }
  factors.bishop = found.front().factor;
  factors.spencer = least(model, path, grid, Method::spencer);
  factors.morgenstern_price = least(model, path, grid, Method::morgenstern_price);
  factors.surface = describe(model, path, found.front());
  return factors;
}

std::optional<double> undrained_bishop(const Section& section, const Polyline& ground) {
  const SlopeModel model(section, ground, Drainage::undrained);
  const GroundPath path(ground);
  const auto grid = surface_grid(model, path);
  const auto found = find_critical_surfaces(model, path, grid, Method::bishop, starts);
  if (found.empty()) return std::nullopt;
  return found.front().factor;
}

double infinite_slope_undrained(double strength_Pa, double unit_weight, double depth_m,
                                double slope_rad) {
  return strength_Pa / (unit_weight * depth_m * std::sin(slope_rad) * std::cos(slope_rad));
}

}  // namespace leda::solver
