#include "solver/screening/critical_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/screening/bishop.hpp"
#include "solver/screening/morgenstern_price.hpp"

namespace leda::solver {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();
constexpr std::size_t stations_on_ground = 30;
constexpr int coarse_slices = 16;
/// Of the grid, best first: where Spencer and Morgenstern-Price, which have no solution on many
/// surfaces, look for theirs.
constexpr std::size_t tried_by_other_methods = 400;
/// Ends of a surface lie at least this share of the whole relief apart in height.
constexpr double least_fall_share = 0.08;
/// Bends of the arc tried, as a share of the largest whose upper end is vertical.
constexpr std::array bends{0.10, 0.25, 0.40, 0.55, 0.70, 0.85, 0.98};

/// Lowest point of the arc itself, m.
double lowest(const TrialSurface& s) {
  const Arc arc = arc_of(s);
  if (arc.centre.x <= s.left.x) return s.left.z;
  if (arc.centre.x >= s.right.x) return s.right.z;
  return arc.centre.z - arc.radius;
}

/// Highest elevation that the bottom of a stratum reaches; an arc above it never meets it.
double highest_bottom(const SlopeModel& model, std::size_t stratum) {
  std::vector<double> places = model.steps;
  for (const Point& p : model.reference) places.push_back(p.x);
  std::ranges::sort(places);
  Column column(model);
  double highest = model.base;
  for (const double x : places) {
    column.move_to(x);
    highest = std::max(highest, column.bottom(stratum));
  }
  return highest;
}

bool is_neighbour(const FoundSurface& a, const FoundSurface& b) {
  const double reach = 0.15 * (a.at.right - a.at.left);
  return a.at.floor == b.at.floor && std::abs(a.at.left - b.at.left) < reach &&
         std::abs(a.at.right - b.at.right) < reach;
}

std::vector<FoundSurface> best_of_neighbourhoods(std::vector<FoundSurface> all, std::size_t most) {
  std::ranges::sort(all, {}, &FoundSurface::factor);
  std::vector<FoundSurface> best;
  for (const FoundSurface& c : all) {
    if (best.size() == most) break;
    if (std::ranges::none_of(best, [&](const FoundSurface& b) { return is_neighbour(b, c); })) {
      best.push_back(c);
    }
  }
  return best;
}

}  // namespace

std::vector<FoundSurface> surface_grid(const SlopeModel& model, const GroundPath& path) {
  const std::vector<double> stations = path.stations(stations_on_ground);
  const auto [low, high] = std::ranges::minmax(model.ground, {}, &Point::z);
  const double least_fall = least_fall_share * (high.z - low.z);
  std::vector<double> tops;
  for (std::size_t i = 0; i < model.most_strata; ++i) tops.push_back(highest_bottom(model, i));
  std::vector<FoundSurface> all;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    for (std::size_t j = i + 1; j < stations.size(); ++j) {
      if (std::abs(path.at(stations[i]).z - path.at(stations[j]).z) < least_fall) continue;
      for (const double bend : bends) {
        for (std::size_t floor = 0; floor < model.most_strata; ++floor) {
          const SurfaceCoordinates at{stations[i], stations[j], bend, floor};
          const TrialSurface surface = surface_of(path, at);
          if (floor + 1 < model.most_strata && lowest(surface) >= tops[floor]) continue;
          const double factor = factor_of(model, surface, Method::bishop, coarse_slices);
          if (factor < none) all.push_back({at, factor});
        }
      }
    }
  }
  std::ranges::sort(all, {}, &FoundSurface::factor);
  return all;
}

TrialSurface surface_of(const GroundPath& path, const SurfaceCoordinates& at) {
  TrialSurface s{path.at(at.left), path.at(at.right), 0, at.floor};
  const double slope =
      std::atan2(std::abs(s.left.z - s.right.z), std::max(1e-9, s.right.x - s.left.x));
  s.half_angle = at.bend * (std::numbers::pi / 2 - slope);
  return s;
}

double factor_of(const SlopeModel& model, const TrialSurface& surface, Method method,
                 int slice_count) {
  thread_local std::vector<Slice> slices;
  if (!cut_into_slices(model, surface, slice_count, slices)) return none;
  switch (method) {
    case Method::spencer:
      return morgenstern_price(slices, Interslice::constant);
    case Method::morgenstern_price:
      return morgenstern_price(slices, Interslice::half_sine);
    case Method::bishop:
      break;
  }
  return bishop(slices);
}

std::vector<FoundSurface> find_critical_surfaces(const SlopeModel& model, const GroundPath& path,
                                                 const std::vector<FoundSurface>& grid,
                                                 Method method, std::size_t most) {
  std::vector<FoundSurface> found = grid;
  if (method != Method::bishop) {
    found.resize(std::min(found.size(), tried_by_other_methods));
    for (FoundSurface& s : found) {
      s.factor = factor_of(model, surface_of(path, s.at), method, coarse_slices);
    }
    std::erase_if(found, [](const FoundSurface& s) { return !(s.factor < none); });
  }
  found = best_of_neighbourhoods(std::move(found), most);
  for (FoundSurface& surface : found) surface = refine(model, path, surface, method);
  std::erase_if(found, [](const FoundSurface& s) { return !(s.factor < none); });
  std::ranges::sort(found, {}, &FoundSurface::factor);
  return found;
}

}  // namespace leda::solver
