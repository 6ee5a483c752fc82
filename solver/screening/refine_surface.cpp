#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "solver/screening/critical_surface.hpp"

namespace leda::solver {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr int descent_slices = 40;
constexpr int final_slices = 160;
constexpr int most_steps = 60;

/// Nelder and Mead (1965) over ends and bend; the factor is infinite outside, which only turns
/// the simplex back.
class Descent {
 public:
  Descent(const SlopeModel& model, const GroundPath& path, Method method)
      : model_(model), path_(path), method_(method) {}

  FoundSurface from(const FoundSurface& start) {
    floor_ = start.at.floor;
    const double span = start.at.right - start.at.left;
    corners_ = {vertex(start.at.left, start.at.right, start.at.bend),
                vertex(start.at.left - 0.1 * span, start.at.right, start.at.bend),
                vertex(start.at.left, start.at.right + 0.1 * span, start.at.bend),
                vertex(start.at.left, start.at.right, start.at.bend * 0.85)};
    for (int i = 0; i < most_steps && !is_small(); ++i) step();
    std::ranges::sort(corners_, {}, &Vertex::factor);
    return {coordinates(corners_[0].x), corners_[0].factor};
  }

 private:
  struct Vertex {
    std::array<double, 3> x;
    double factor;
  };

  SurfaceCoordinates coordinates(const std::array<double, 3>& x) const {
    return {std::clamp(x[0], 0.0, path_.length()), std::clamp(x[1], 0.0, path_.length()),
            std::clamp(x[2], 0.02, 1.0), floor_};
  }

  Vertex vertex(const std::array<double, 3>& x) const {
    const SurfaceCoordinates at = coordinates(x);
    if (at.right <= at.left) return {x, none};
    return {x, factor_of(model_, surface_of(path_, at), method_, descent_slices)};
  }

  Vertex vertex(double left, double right, double bend) const {
    return vertex(std::array{left, right, bend});
  }

  /// The point beyond (or short of) the middle of the three best, seen from the worst.
  Vertex across(double share) const {
    std::array<double, 3> x{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double middle = (corners_[0].x[k] + corners_[1].x[k] + corners_[2].x[k]) / 3;
      x[k] = middle + share * (middle - corners_[3].x[k]);
    }
    return vertex(x);
  }

  void step() {
    std::ranges::sort(corners_, {}, &Vertex::factor);
    const Vertex reflected = across(1);
    if (reflected.factor < corners_[0].factor) {
      const Vertex further = across(2);
      corners_[3] = further.factor < reflected.factor ? further : reflected;
      return;
    }
    if (reflected.factor < corners_[2].factor) {
      corners_[3] = reflected;
      return;
    }
    const Vertex nearer = across(reflected.factor < corners_[3].factor ? 0.5 : -0.5);
    if (nearer.factor < std::min(reflected.factor, corners_[3].factor)) {
      corners_[3] = nearer;
      return;
    }
    for (std::size_t i = 1; i < 4; ++i) {
      std::array<double, 3> x{};
      for (std::size_t k = 0; k < 3; ++k) x[k] = 0.5 * (corners_[0].x[k] + corners_[i].x[k]);
      corners_[i] = vertex(x);
    }
  }

  bool is_small() const {
    const auto [least, most] = std::ranges::minmax(corners_, {}, &Vertex::factor);
    return most.factor - least.factor < 1e-4 * least.factor;
  }

  const SlopeModel& model_;
  const GroundPath& path_;
  Method method_;
  std::size_t floor_ = 0;
  std::array<Vertex, 4> corners_{};
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
