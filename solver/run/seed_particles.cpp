#include "solver/run/seed_particles.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace leda::solver {

namespace {

constexpr double jitter_m = 1e-6;

std::vector<const Material*> layer_materials(const Section& section) {
  std::vector<const Material*> materials;
  for (const Layer& layer : section.layers)
    materials.push_back(&section.materials.at(layer.material));
  return materials;
}

std::vector<std::size_t> material_indices(const Section& section) {
  std::vector<std::size_t> indices;
  for (const Layer& layer : section.layers) {
    const auto at = section.materials.find(layer.material);
    indices.push_back(static_cast<std::size_t>(std::distance(section.materials.begin(), at)));
  }
  return indices;
}

double highest(const Polyline& line) {
  return std::max_element(line.begin(), line.end(), [](Point a, Point b) { return a.z < b.z; })->z;
}

// Room above the ground for what is pushed up; rows that nothing reaches cost only memory.
double headroom(double height, double h) { return std::max(6 * h, height); }

}  // namespace

double overburden(const Section& section, Point p) {
  double top = elevation_at(section.ground, p.x), weight = 0;
  for (std::size_t i = 0; i < section.layers.size() && top > p.z; ++i) {
    const double bottom =
        i + 1 == section.layers.size() ? section.base_m : layer_bottom(section, i, p.x);
    const double to = std::max(std::min(bottom, top), p.z);
    weight += section.materials.at(section.layers[i].material).unit_weight * (top - to);
    top = to;
  }
  return weight;
}

Seeded seed_particles(const Section& section, const Resolution& resolution) {
  Seeded seeded;
  const double h = resolution.cell_m;
  const auto per_side =
      static_cast<std::size_t>(std::lround(std::sqrt(resolution.particles_per_cell)));
  seeded.origin_x = section.ground.front().x;
  seeded.origin_z = section.base_m;
  seeded.spacing = h / static_cast<double>(per_side);
  const double height = highest(section.ground) - section.base_m;
  const double length = section.ground.back().x - seeded.origin_x;
  seeded.size = grid_over(h, length, height + headroom(height, h));

  const auto cells_x = static_cast<std::size_t>(std::ceil(length / h - 1e-9));
  const auto cells_z = static_cast<std::size_t>(std::ceil(height / h - 1e-9));
  const auto materials = layer_materials(section);
  const auto indices = material_indices(section);
  LawTableBuilder laws(section, h);
  std::mt19937_64 random(resolution.seed);
  const std::size_t most = cells_x * cells_z * per_side * per_side;
  seeded.particles.reserve(most);
  seeded.start_x.reserve(most);
  for (std::size_t i = 0; i < cells_x * per_side; ++i) {
    const double x = (static_cast<double>(i) + 0.5) * seeded.spacing;
    const double ground = elevation_at(section.ground, x + seeded.origin_x) - section.base_m;
    for (std::size_t k = 0; k < cells_z * per_side; ++k) {
      const double z = (static_cast<double>(k) + 0.5) * seeded.spacing;
      if (z >= ground) break;
      const Point at{x + seeded.origin_x, z + seeded.origin_z};
      const std::size_t layer = layer_at(section, at);
      const Material& m = *materials[layer];
      const double vertical = overburden(section, at);
      const double u = pore_pressure(section, at);
      const double horizontal = m.k0 * (vertical - u) + u;
      const double volume = seeded.spacing * seeded.spacing;
      const auto moved = [&](double value) {
        if (resolution.seed == 0) return value;
        return value + jitter_m * (2 * static_cast<double>(random()) / 18446744073709551616.0 - 1);
      };
      Particle p;
      p.x = moved(x);
      p.z = moved(z);
      p.sxx = p.syy = -horizontal;
      p.szz = -vertical;
      p.mass = m.unit_weight / gravity * volume;
      p.volume = volume;
      p.law = laws.row(indices[layer], ground - z, at.z);
      p.id = static_cast<std::int32_t>(seeded.particles.size());
      seeded.particles.push_back(p);
      seeded.start_x.push_back(static_cast<float>(p.x));
    }
  }
  seeded.laws = laws.table();
  seeded.averages = nearly_incompressible(seeded.laws);
  return seeded;
}

}  // namespace leda::solver
