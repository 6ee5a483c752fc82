#pragma once
// The search for the critical surface: arcs between all parts of the ground, both ways of sliding,
// cut off by the base or by the bottom of any layer.

#include <vector>

#include "solver/screening/ground_path.hpp"
#include "solver/screening/slip_surface.hpp"

namespace leda::solver {

enum class Method { bishop, spencer, morgenstern_price };

/// A surface as the search moves it: the distances of its ends along the ground, and its bend.
struct SurfaceCoordinates {
  double left = 0, right = 0;
  double bend = 0;        ///< of the arc, as a share of that whose upper end is vertical, 0 to 1
  std::size_t floor = 0;  ///< as in TrialSurface
};

struct FoundSurface {
  SurfaceCoordinates at;
  double factor = 0;
};

TrialSurface surface_of(const GroundPath& path, const SurfaceCoordinates& at);

/// Factor of one surface; infinity where it is not admissible.
double factor_of(const SlopeModel& model, const TrialSurface& surface, Method method,
                 int slice_count);

/// Bishop over a grid of arcs, the least factor first; empty where nothing slopes.
std::vector<FoundSurface> surface_grid(const SlopeModel& model, const GroundPath& path);

/// The best of the grid by a method, a few from distinct neighbourhoods, each then refined.
/// @param most how many neighbourhoods
/// @return the least factor first; empty where the method has no solution anywhere
std::vector<FoundSurface> find_critical_surfaces(const SlopeModel& model, const GroundPath& path,
                                                 const std::vector<FoundSurface>& grid,
                                                 Method method, std::size_t most);

/// Moves the ends along the ground and bends the arc until the factor is least (Nelder and Mead
/// 1965), then takes that factor with many slices.
FoundSurface refine(const SlopeModel& model, const GroundPath& path, const FoundSurface& start,
                    Method method);

}  // namespace leda::solver
