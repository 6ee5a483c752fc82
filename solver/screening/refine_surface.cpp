#include <algorithm>
#include <limits>
#include <nlopt.hpp>
#include <vector>

#include "solver/screening/critical_surface.hpp"

namespace leda::solver {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr int descent_slices = 40;
constexpr int final_slices = 160;
constexpr int most_surfaces = 120;
constexpr double flattest = 0.02;  // bend of an arc
/// What turns the simplex back: NLopt ends at an infinite value.
constexpr double inadmissible = 1e9;

/// Nelder and Mead (1965), as NLopt has it, over ends and bend.
class Descent {
 public:
  Descent(const SlopeModel& model, const GroundPath& path, Method method)
      : model_(model), path_(path), method_(method), search_(nlopt::LN_NELDERMEAD, 3) {
    search_.set_min_objective(&Descent::factor, this);
    search_.set_lower_bounds({0, 0, flattest});
    search_.set_upper_bounds({path.length(), path.length(), 1});
    search_.set_ftol_rel(1e-4);
    search_.set_maxeval(most_surfaces);
  }

  FoundSurface from(const FoundSurface& start) {
    floor_ = start.at.floor;
    const double span = start.at.right - start.at.left;
    search_.set_initial_step(std::vector{-0.1 * span, 0.1 * span, -0.15 * start.at.bend});
    std::vector<double> x{start.at.left, start.at.right, std::clamp(start.at.bend, flattest, 1.0)};
    double least = none;
    search_.optimize(x, least);
    return {coordinates(x), least < inadmissible ? least : none};
  }

 private:
  SurfaceCoordinates coordinates(const std::vector<double>& x) const {
    return {x[0], x[1], x[2], floor_};
  }

  static double factor(const std::vector<double>& x, std::vector<double>& /*gradient*/,
                       void* descent) {
    const auto& self = *static_cast<const Descent*>(descent);
    const SurfaceCoordinates at = self.coordinates(x);
    if (at.right <= at.left) return inadmissible;
    return std::min(inadmissible, factor_of(self.model_, surface_of(self.path_, at), self.method_,
                                            descent_slices));
  }

  const SlopeModel& model_;
  const GroundPath& path_;
  Method method_;
  nlopt::opt search_;
  std::size_t floor_ = 0;
};

/// A method may have no solution on a surface that another found: flatter arcs are easier.
FoundSurface flattened_until_solved(const SlopeModel& model, const GroundPath& path,
                                    FoundSurface start, Method method) {
  for (int i = 0; i < 8; ++i) {
    const TrialSurface surface = surface_of(path, start.at);
    if (factor_of(model, surface, method, descent_slices) < none) break;
    start.at.bend *= 0.85;
  }
  return start;
}

}  // namespace

FoundSurface refine(const SlopeModel& model, const GroundPath& path, const FoundSurface& start,
                    Method method) {
  Descent descent(model, path, method);
  FoundSurface found = descent.from(flattened_until_solved(model, path, start, method));
  // A second simplex, started anew, leaves the corners of the ground where the first one stuck.
  found = descent.from(found);
  const double exact = factor_of(model, surface_of(path, found.at), method, final_slices);
  // With more slices the method may fail where the arc just touches its floor.
  if (exact < none) found.factor = exact;
  return found;
}

}  // namespace leda::solver
