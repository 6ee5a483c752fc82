#include "solver/section/validate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/section/model_size.hpp"
#include "solver/section/validate_section.hpp"
#include "solver/section/validate_seen.hpp"

namespace leda {
namespace {

/// More frames than this would fill a disk rather than show a slide.
constexpr double most_frames = 10'000;
constexpr double least_cells_along = 5;
constexpr double least_cells_high = 2;
/// A bank of fewer cells has no slip surface to go by.
constexpr double least_cells_of_bank = 2;

bool check_cell_against_ground(const Section& section, const Resolution& resolution,
                               FaultList& faults) {
  const double h = resolution.cell_m;
  const double length = section.ground.back().x - section.ground.front().x;
  const double height = std::ranges::max(section.ground, {}, &Point::z).z - section.base_m;
  if (length < least_cells_along * h) {
    faults.add("/resolution/cell_m", "is " + show(h) + " m, must be at most a fifth of the " +
                                         "section's length (" + show(length) + " m)");
  }
  if (height < least_cells_high * h) {
    faults.add("/resolution/cell_m", "is " + show(h) + " m, must be at most half of the ground's " +
                                         "height above the base (" + show(height) + " m)");
  }
  const double particles = particles_of(section, resolution);
  if (!(particles <= double(most_particles))) {
    faults.add("/resolution/cell_m",
               "is " + show(h) + " m, which makes about " + show(std::round(particles)) +
                   " particles, more than " + std::to_string(most_particles) +
                   ": take larger cells, fewer particles_per_cell or a smaller section");
  }
  return length >= least_cells_along * h && height >= least_cells_high * h;
}

void check_cell_against_bank(const CrestAndToe& bank, double cell_m, FaultList& faults) {
  const double height = bank.crest.z - bank.toe.z;
  if (height >= least_cells_of_bank * cell_m) return;
  faults.add("/resolution/cell_m",
             "is " + show(cell_m) + " m, must be at most half of the height " + "of the bank (" +
                 show(height) + " m); an eighth of it or less gives a number to go by");
}

void check_cell_against_band(const Section& section, double cell, FaultList& faults) {
  for (const auto& [name, m] : section.materials) {
    if (!m.softening || m.softening->regularization != Regularization::band) continue;
    const double most = most_cell_of_band * m.softening->band_m;
    if (!(most > 0) || cell <= most * (1 + 1e-9)) continue;
    faults.add("/resolution/cell_m", "is " + show(cell) + " m, must be at most " + show(most) +
                                         " m, half of the band of " + name + " (band_m " +
                                         show(m.softening->band_m) + " m)");
    return;
  }
}

bool check_resolution(const Resolution& resolution, FaultList& faults) {
  constexpr std::array squares{1, 4, 9, 16, 25};
  const bool cell = faults.positive("/resolution/cell_m", resolution.cell_m, "m");
  const bool square = std::ranges::find(squares, resolution.particles_per_cell) != squares.end();
  if (!square) {
    faults.add(
        "/resolution/particles_per_cell",
        "is " + std::to_string(resolution.particles_per_cell) + ", must be one of 1, 4, 9, 16, 25");
  }
  return cell && square;
}

double side_of(Point a, Point b, Point p) {
  return (b.x - a.x) * (p.z - a.z) - (b.z - a.z) * (p.x - a.x);
}

bool is_between(Point a, Point b, Point p) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.z >= std::min(a.z, b.z) &&
         p.z <= std::max(a.z, b.z);
}

/// Segments ab and cd share a point.
bool touch(Point a, Point b, Point c, Point d) {
  const double c_side = side_of(a, b, c), d_side = side_of(a, b, d);
  const double a_side = side_of(c, d, a), b_side = side_of(c, d, b);
  if (((c_side > 0) != (d_side > 0)) && ((a_side > 0) != (b_side > 0)) && c_side != 0 &&
      d_side != 0 && a_side != 0 && b_side != 0) {
    return true;
  }
  return (c_side == 0 && is_between(a, b, c)) || (d_side == 0 && is_between(a, b, d)) ||
         (a_side == 0 && is_between(c, d, a)) || (b_side == 0 && is_between(c, d, b));
}

/// The corners without a repeated last one.
Polyline corners_of(const Polyline& polygon) {
  Polyline corners = polygon;
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

void check_crossing(const Polyline& corners, FaultList& faults) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours around the closing edge
      if (!touch(corners[i], corners[i + 1], corners[j], corners[(j + 1) % n])) continue;
      faults.add("/trigger/polygon", "crosses itself: the edge from corner " + std::to_string(i) +
                                         " meets the edge from corner " + std::to_string(j));
      return;
    }
  }
}

/// Whether the polygon holds ground. Between corners of either line both are straight, so an
/// edge of the polygon that is anywhere below the ground is so at one of those places.
bool holds_ground(const Section& section, const Polyline& corners) {
  const double left = section.ground.front().x, right = section.ground.back().x;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point a = corners[i];
    const Point b = corners[(i + 1) % corners.size()];
    const auto edge_is_below = [&](double x) {
      if (x < std::min(a.x, b.x) || x > std::max(a.x, b.x) || x < left || x > right) return false;
      const double z =
          a.x == b.x ? std::min(a.z, b.z) : a.z + (b.z - a.z) * ((x - a.x) / (b.x - a.x));
      return z < elevation_at(section.ground, x);
    };
    if (edge_is_below(a.x) || edge_is_below(b.x)) return true;
    for (const Point& g : section.ground) {
      if (edge_is_below(g.x)) return true;
    }
  }
  return false;
}

void check_excavation(const Section& section, bool ground_is_sound,
                      const ExcavationTrigger& excavation, FaultList& faults) {
  const Polyline corners = corners_of(excavation.polygon);
  if (corners.size() < 3) {
    faults.add("/trigger/polygon",
               "has " + std::to_string(corners.size()) + " corners, must have at least 3");
    return;
  }
  bool sound = true;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::string at = "/trigger/polygon/" + std::to_string(i);
    sound = faults.finite(at + "/0", corners[i].x) && sound;
    sound = faults.finite(at + "/1", corners[i].z) && sound;
  }
  if (!sound) return;
  check_crossing(corners, faults);
  if (ground_is_sound && !holds_ground(section, corners)) {
    faults.add("/trigger/polygon", "lies outside the section: it holds no ground to remove");
  }
}

void check_trigger(const Section& section, bool ground_is_sound,
                   const std::optional<CrestAndToe>& bank, const Trigger& trigger,
                   FaultList& faults) {
  if (const auto* excavation = std::get_if<ExcavationTrigger>(&trigger)) {
    check_excavation(section, ground_is_sound, *excavation, faults);
    return;
  }
  const auto& cut = std::get<UndrainedTrigger>(trigger).then_toe_cut_m;
  if (!cut || !faults.positive("/trigger/then_toe_cut_m", *cut, "m") || !bank) return;
  const double height = bank->crest.z - bank->toe.z;
  if (*cut >= height) {
    faults.add("/trigger/then_toe_cut_m", "is " + show(*cut) +
                                              " m, must be less than the height of the bank (" +
                                              show(height) + " m)");
  }
}

void check_run(const RunSettings& settings, FaultList& faults) {
  const auto fraction = [&](const char* at, double v) {
    faults.within(at, v, v >= 0 && v < 1, "at least 0 and below 1");
  };
  fraction("/damping/initial", settings.damping.initial);
  fraction("/damping/dynamic", settings.damping.dynamic);
  const double factor = settings.time_step_factor;
  const bool sound = faults.within("/time_step_factor", factor, factor > 0 && factor <= 1,
                                   "greater than 0 and at most 1");
  if (sound && takes_long_steps(settings) && settings.resolution.particles_per_cell == 1) {
    faults.add("/time_step_factor", "is " + show(factor) + ", must be at most " +
                                        show(most_factor_unsoftened) +
                                        " with one particle a cell: on borders of splines all of "
                                        "the ground limits the step then");
  }
  const double most = settings.stop.max_time_s;
  const bool stop = faults.positive("/stop/max_time_s", most, "s");
  const double interval = settings.output.frame_interval_s;
  if (faults.within("/output/frame_interval_s", interval, interval >= 0, "at least 0 s") && stop &&
      interval > 0 && most / interval > most_frames) {
    faults.add("/output/frame_interval_s", "is " + show(interval) + " s, must be at least " +
                                               show(most / most_frames) + " s: no more than " +
                                               show(most_frames) + " frames are kept");
  }
}

}  // namespace

std::vector<Fault> validate_settings(const RunSettings& settings) {
  FaultList faults;
  check_trigger({}, false, std::nullopt, settings.trigger, faults);
  check_resolution(settings.resolution, faults);
  check_run(settings, faults);
  return faults.take();
}

std::vector<Fault> validate(const Section& section, const RunSettings& settings) {
  FaultList faults;
  const bool ground = check_ground(section, faults);
  check_soil(section, ground, faults);
  for (Fault& f : validate_materials(section.materials, "/materials")) {
    faults.add(std::move(f.pointer), std::move(f.message));
  }
  std::optional<CrestAndToe> bank;
  if (ground) {
    check_water_table(section, faults);
    bank = check_bank(section, faults);
  }
  check_trigger(section, ground, bank, settings.trigger, faults);
  const bool resolution = check_resolution(settings.resolution, faults);
  if (ground && resolution && check_cell_against_ground(section, settings.resolution, faults) &&
      bank) {
    check_cell_against_bank(*bank, settings.resolution.cell_m, faults);
  }
  if (resolution) check_cell_against_band(section, settings.resolution.cell_m, faults);
  check_run(settings, faults);
  if (faults.none()) check_weight_under_water(section, settings.resolution, faults);
  if (faults.none()) check_seen(section, settings, bank, faults);
  return faults.take();
}

}  // namespace leda
