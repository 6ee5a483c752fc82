#include "solver/section/seen_by_particles.hpp"

#include <algorithm>
#include <cmath>

#include "solver/section/crest_and_toe.hpp"

namespace leda {
namespace {

/// A tenth of a millimetre of water: what rounding leaves where a layer ends at the water table.
constexpr double least_pressure_Pa = 1;

// The columns and rows that solver/run/seed_particles.cpp fills.
struct Lattice {
  double left_m, base_m, spacing_m;
  std::size_t columns;

  double x(std::size_t column) const {
    return left_m + (static_cast<double>(column) + 0.5) * spacing_m;
  }
  /// Rows whose centre lies at `bottom` or above it, and below `top`.
  double rows(double bottom, double top) const {
    const auto below = [&](double z) { return std::ceil((z - base_m) / spacing_m - 0.5); };
    return std::max(0.0, below(top) - std::max(0.0, below(bottom)));
  }
  /// Adds what of a body lies in one column.
  void add(Seen& seen, double bottom, double top) const {
    if (!(top > bottom)) return;
    const double count = rows(bottom, top);
    seen.area_m2 += (top - bottom) * spacing_m;
    seen.seen_m2 += count * spacing_m * spacing_m;
    seen.length_m += spacing_m;
    if (count == 0) seen.missed_m += spacing_m;
  }
};

Lattice lattice_of(const Section& section, const Resolution& resolution) {
  const double length = section.ground.back().x - section.ground.front().x;
  const double per_side = std::round(std::sqrt(resolution.particles_per_cell));
  const double cells = std::ceil(length / resolution.cell_m - 1e-9);
  return {section.ground.front().x, section.base_m, particle_spacing(resolution),
          static_cast<std::size_t>(std::max(0.0, cells) * per_side)};
}

// Elevations at which the edge of a polygon crosses a vertical, upwards.
std::vector<double> crossings(const Polyline& polygon, double x) {
  std::vector<double> at;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point &a = polygon[i], &b = polygon[j];
    if ((a.x > x) == (b.x > x)) continue;
    at.push_back(a.z + (b.z - a.z) * ((x - a.x) / (b.x - a.x)));
  }
  std::ranges::sort(at);
  return at;
}

bool continues_into_neighbour(const std::vector<Layer>& layers, std::size_t layer) {
  const auto same = [&](std::size_t other) {
    return layers[other].material == layers[layer].material;
  };
  return (layer > 0 && same(layer - 1)) || (layer + 1 < layers.size() && same(layer + 1));
}

/// Depths below the toe would look for the toe at every column.
Section with_toe(Section section) {
  const auto bank = find_crest_and_toe(section.ground);
  if (bank && !section.toe) section.toe = bank->toe;
  return section;
}

struct Interval {
  double bottom = 0, top = 0;
};

/// Bottoms and tops of the layers at x, in their order, downwards.
std::vector<Interval> intervals_at(const Section& section, double x) {
  std::vector<Interval> intervals;
  double top = std::max(elevation_at(section.ground, x), section.base_m);
  for (const Layer& layer : layers_at(section, x)) {
    const double bottom = std::min(top, layer_bottom(section, layer, x));
    intervals.push_back({bottom, top});
    top = bottom;
  }
  return intervals;
}

/// Where a material lies at x, downwards; layers of it upon one another are one body.
std::vector<Interval> bodies_at(const Section& section, double x, const std::string& material) {
  const std::vector<Layer>& layers = layers_at(section, x);
  const std::vector<Interval> intervals = intervals_at(section, x);
  std::vector<Interval> bodies;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (layers[i].material != material) continue;
    if (!bodies.empty() && bodies.back().bottom == intervals[i].top) {
      bodies.back().bottom = intervals[i].bottom;
    } else {
      bodies.push_back(intervals[i]);
    }
  }
  return bodies;
}

}  // namespace

double particle_spacing(const Resolution& resolution) {
  return resolution.cell_m / std::round(std::sqrt(resolution.particles_per_cell));
}

std::vector<SeenLayer> seen_layers(const Section& section, const Resolution& resolution) {
  const Section sound = with_toe(section);
  std::vector<SeenLayer> seen;
  std::vector<std::size_t> first_of_list;
  for (std::size_t list = 0; list < layer_lists(section); ++list) {
    const std::vector<Layer>& layers = layers_of(section, list);
    first_of_list.push_back(seen.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
      seen.push_back({list, i, {}, continues_into_neighbour(layers, i)});
    }
  }
  const Lattice lattice = lattice_of(section, resolution);
  for (std::size_t column = 0; column < lattice.columns; ++column) {
    const double x = lattice.x(column);
    const std::size_t list = layer_list_at(section, x);
    std::size_t i = first_of_list[list];
    for (const auto& [bottom, top] : intervals_at(sound, x)) {
      lattice.add(seen[i++].seen, bottom, top);
    }
  }
  return seen;
}

std::vector<SeenExtreme> seen_extremes(const Section& section, const Resolution& resolution,
                                       const std::string& material) {
  const Strength& strength = section.materials.at(material).peak_strength;
  std::vector<SeenExtreme> seen;
  for (const StrengthExtreme& extreme : extremes_of(strength)) seen.push_back({extreme, {}});
  if (seen.empty()) return seen;
  const Section sound = with_toe(section);
  const Lattice lattice = lattice_of(section, resolution);
  for (std::size_t column = 0; column < lattice.columns; ++column) {
    const double x = lattice.x(column);
    const double ground = elevation_at(section.ground, x);
    const auto elevations = [&](double from, double to) {
      if (strength.by == Strength::By::elevation) return Interval{from, to};
      return Interval{ground - to, ground - from};
    };
    for (const auto& [bottom, top] : bodies_at(sound, x, material)) {
      for (auto& [extreme, of] : seen) {
        const Interval core = elevations(extreme.core_from, extreme.core_to);
        if (core.top <= bottom || core.bottom >= top) continue;
        const Interval band = elevations(extreme.from, extreme.to);
        lattice.add(of, std::max(bottom, band.bottom), std::min(top, band.top));
      }
    }
  }
  return seen;
}

Seen seen_inside(const Section& section, const Resolution& resolution, const Polyline& polygon) {
  const Lattice lattice = lattice_of(section, resolution);
  Seen seen;
  for (std::size_t column = 0; column < lattice.columns; ++column) {
    const double x = lattice.x(column);
    const double ground = elevation_at(section.ground, x);
    const std::vector<double> at = crossings(polygon, x);
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      lattice.add(seen, std::max(at[i], section.base_m), std::min(at[i + 1], ground));
    }
  }
  return seen;
}

bool lies_under_water(const Section& section, const Resolution& resolution,
                      const std::string& material) {
  const Section sound = with_toe(section);
  const Lattice lattice = lattice_of(section, resolution);
  for (std::size_t column = 0; column < lattice.columns; ++column) {
    const double x = lattice.x(column);
    for (const auto& [bottom, top] : bodies_at(sound, x, material)) {
      if (top > bottom && pore_pressure(section, {x, bottom}) > least_pressure_Pa) return true;
    }
  }
  return false;
}

}  // namespace leda
