#include "solver/run/seed_particles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "solver/section/overburden.hpp"

namespace leda::solver {

namespace {

constexpr double jitter_m = 1e-6;

/// A material and its index among those of the section.
struct Named {
  const Material* material;
  std::size_t index;
};

/// By the place of a layer in memory: names are looked up once, not for each particle.
std::map<const Layer*, Named> materials_of_layers(const Section& section) {
  std::map<const Layer*, Named> named;
  for (std::size_t list = 0; list < layer_lists(section); ++list) {
    for (const Layer& layer : layers_of(section, list)) {
      const auto at = section.materials.find(layer.material);
      const auto index = std::distance(section.materials.begin(), at);
      named[&layer] = {&at->second, static_cast<std::size_t>(index)};
    }
  }
  return named;
}

double highest(const Polyline& line) {
  return std::max_element(line.begin(), line.end(), [](Point a, Point b) { return a.z < b.z; })->z;
}

/// Of `count` rows of particles, m above the base.
std::vector<double> rows_of_particles(std::size_t count, double spacing) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < count; ++k) {
    rows.push_back((static_cast<double>(k) + 0.5) * spacing);
  }
  return rows;
}

std::vector<double> elevations_of(std::vector<double> rows, double base) {
  for (double& z : rows) z += base;
  return rows;
}

std::size_t rows_below(double ground, const std::vector<double>& rows) {
  return static_cast<std::size_t>(std::ranges::lower_bound(rows, ground) - rows.begin());
}

/// The ground of a particle, as it lies there.
Particle particle_at_rest(const Section& section, const Material& m, Point at, double spacing) {
  const double vertical = overburden(section, at);
  const double u = pore_pressure(section, at);
  Particle p;
  p.sxx = p.syy = -(m.k0 * (vertical - u) + u);
  p.szz = -vertical;
  p.volume = spacing * spacing;
  p.mass = m.unit_weight / gravity * p.volume;
  return p;
}

// Room above the ground for what is pushed up; rows that nothing reaches cost only memory.
double headroom(double height, double h) { return std::max(6 * h, height); }

}  // namespace

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
  const auto materials = materials_of_layers(section);
  LawTableBuilder laws(section, h);
  const auto rows = rows_of_particles(cells_z * per_side, seeded.spacing);
  SampledFields fields(section, resolution.seed, elevations_of(rows, seeded.origin_z));
  std::mt19937_64 random(resolution.seed);
  const std::size_t most = cells_x * cells_z * per_side * per_side;
  seeded.particles.reserve(most);
  seeded.start_x.reserve(most);
  for (std::size_t i = 0; i < cells_x * per_side; ++i) {
    const double x = (static_cast<double>(i) + 0.5) * seeded.spacing;
    const double ground = elevation_at(section.ground, x + seeded.origin_x) - section.base_m;
    const std::size_t in_ground = rows_below(ground, rows);
    fields.move_to(x + seeded.origin_x, in_ground);
    for (std::size_t k = 0; k < in_ground; ++k) {
      const double z = rows[k];
      const Point at{x + seeded.origin_x, z + seeded.origin_z};
      const Named& named = materials.at(&layer_at(section, at));
      const auto moved = [&](double value) {
        if (resolution.seed == 0) return value;
        return value + jitter_m * (2 * static_cast<double>(random()) / 18446744073709551616.0 - 1);
      };
      Particle p = particle_at_rest(section, *named.material, at, seeded.spacing);
      p.x = moved(x);
      p.z = moved(z);
      p.law = laws.row(named.index, ground - z, at.z, pore_pressure(section, at),
                       fields.take(named.index, k));
      p.id = static_cast<std::int32_t>(seeded.particles.size());
      seeded.particles.push_back(p);
      seeded.start_x.push_back(static_cast<float>(p.x));
    }
  }
  seeded.laws = laws.table();
  seeded.fields = fields.sampled();
  seeded.averages = nearly_incompressible(seeded.laws);
  return seeded;
}

}  // namespace leda::solver
