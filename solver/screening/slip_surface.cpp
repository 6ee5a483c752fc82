#include "solver/screening/slip_surface.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {
namespace {

constexpr double least_width_m = 0.05;
constexpr double least_fall_m = 1e-3;
/// A slice may stand out of the ground by this much: rounding where a surface skims it.
constexpr double most_overhang_m = 1e-6;

/// Edges of the slices, evenly spaced but for those moved onto vertical faces.
void place_edges(const SlopeModel& model, double from, double to, int count,
                 std::vector<double>& edges) {
  edges.resize(static_cast<std::size_t>(count) + 1);
  for (int i = 0; i <= count; ++i) {
    edges[static_cast<std::size_t>(i)] = from + (to - from) * i / count;
  }
  for (const double step : model.steps) {
    if (step <= from || step >= to) continue;
    const auto nearest = static_cast<int>(std::lround((step - from) / (to - from) * count));
    edges[static_cast<std::size_t>(std::clamp(nearest, 1, count - 1))] = step;
  }
}

double arc_elevation(const Arc& arc, double x) {
  const double dx = x - arc.centre.x;
  return arc.centre.z - std::sqrt(std::max(0.0, arc.radius * arc.radius - dx * dx));
}

struct BaseEnd {
  double x = 0, z = 0;
  bool on_floor = false;
};

BaseEnd base_end(const SlopeModel& model, const TrialSurface& surface, const Arc& arc,
                 Column& column, double x) {
  const double z = arc_elevation(arc, x);
  double floor = model.base;
  if (surface.floor + 1 < model.most_strata) {
    column.move_to(x);
    floor = column.bottom(surface.floor);
  }
  return z > floor ? BaseEnd{x, z, false} : BaseEnd{x, floor, true};
}

/// @return false where the ground lies below the base
bool fill(const Column& column, const Arc& arc, const BaseEnd& a, const BaseEnd& b,
          double direction, std::size_t floor, Slice& slice) {
  const double mid = 0.5 * (a.z + b.z);
  if (column.ground() < mid - most_overhang_m) return false;
  slice.width = b.x - a.x;
  slice.length = std::hypot(slice.width, b.z - a.z);
  slice.sin_a = direction * (a.z - b.z) / slice.length;
  slice.cos_a = slice.width / slice.length;
  slice.weight = column.weight_above(mid) * slice.width;
  slice.resistance =
      a.on_floor && b.on_floor ? column.resistance_on(floor) : column.resistance_at(mid);
  const double rx = direction * (0.5 * (a.x + b.x) - arc.centre.x);
  const double rz = mid - arc.centre.z;
  slice.weight_arm = -rx;
  slice.shear_arm = -(rx * slice.sin_a + rz * slice.cos_a);
  slice.normal_arm = rx * slice.cos_a - rz * slice.sin_a;
  return true;
}

}  // namespace

Arc arc_of(const TrialSurface& surface) {
  const double dx = surface.right.x - surface.left.x;
  const double dz = surface.right.z - surface.left.z;
  const double chord = std::hypot(dx, dz);
  const double radius = chord / (2 * std::sin(surface.half_angle));
  const double rise = radius * std::cos(surface.half_angle);
  return {{0.5 * (surface.left.x + surface.right.x) - rise * dz / chord,
           0.5 * (surface.left.z + surface.right.z) + rise * dx / chord},
          radius};
}

bool cut_into_slices(const SlopeModel& model, const TrialSurface& surface, int count,
                     std::vector<Slice>& slices) {
  const double fall = surface.left.z - surface.right.z;
  if (surface.right.x - surface.left.x < least_width_m || std::abs(fall) < least_fall_m) {
    return false;
  }
  const double direction = fall > 0 ? 1 : -1;
  const Arc arc = arc_of(surface);
  if (std::max(surface.left.z, surface.right.z) > arc.centre.z + 1e-9 * arc.radius) return false;
  thread_local std::vector<double> edges;
  place_edges(model, surface.left.x, surface.right.x, count, edges);
  slices.resize(static_cast<std::size_t>(count));
  Column middles(model);
  Column ends(model);
  BaseEnd a{surface.left.x, surface.left.z, false};
  for (std::size_t i = 0; i < slices.size(); ++i) {
    BaseEnd b{surface.right.x, surface.right.z, false};
    if (i + 1 < slices.size()) b = base_end(model, surface, arc, ends, edges[i + 1]);
    middles.move_to(0.5 * (a.x + b.x));
    if (!fill(middles, arc, a, b, direction, surface.floor, slices[i])) return false;
    a = b;
  }
  if (direction < 0) std::ranges::reverse(slices);
  return true;
}

Polyline line_of(const SlopeModel& model, const TrialSurface& surface, int points) {
  const Arc arc = arc_of(surface);
  Column column(model);
  Polyline line{surface.left};
  for (int i = 1; i + 1 < points; ++i) {
    const double x =
        surface.left.x + (surface.right.x - surface.left.x) * i / static_cast<double>(points - 1);
    const BaseEnd end = base_end(model, surface, arc, column, x);
    line.push_back({end.x, end.z});
  }
  line.push_back(surface.right);
  return line;
}

}  // namespace leda::solver
