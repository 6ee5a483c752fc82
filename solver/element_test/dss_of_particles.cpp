#include "solver/element_test/dss_of_particles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "solver/element_test/dissipation.hpp"
#include "solver/kernel/sort_particles.hpp"
#include "solver/kernel/transfer.hpp"

namespace leda::solver {
namespace {

constexpr double coarse_step = 1e-4;      // of strain
constexpr double loss_a_step = 0.002;     // of the peak, at most
constexpr double change_a_point = 0.002;  // of the peak, between points that are kept
constexpr double stretch_a_point = 1.02;  // of the strain, between points that are kept

LawTable law_of(const Material& material, double peak_Pa, double cell_m) {
  Section section;
  Material at_place = material;
  at_place.peak_strength = {.by = Strength::By::constant, .constant_Pa = peak_Pa, .table = {}};
  section.materials["specimen"] = at_place;
  LawTableBuilder builder(section, cell_m);
  builder.row(0, 0, 0);
  return builder.table();
}

/// A lattice in the cell from (h, h) to (2h, 2h).
Particles specimen(const Material& material, const ParticleShear& test) {
  const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(test.particles_per_cell))));
  const double spacing = test.cell_m / side;
  Particles p;
  p.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (int i = 0; i < side * side; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const int column = i / side, row = i % side;
    p.x[k] = test.cell_m + (column + 0.5) * spacing;
    p.z[k] = test.cell_m + (row + 0.5) * spacing;
    p.volume[k] = spacing * spacing;
    p.mass[k] = p.volume[k] * material.unit_weight / gravity;
    p.szz[k] = -test.vertical_stress_Pa;
    p.sxx[k] = p.syy[k] = -material.k0 * test.vertical_stress_Pa;
    p.id[k] = i;
  }
  p.fill_padding();
  return p;
}

/// Simple shear at every node: v_x = rate z, v_z = 0.
void move_nodes(Grid& grid, double rate) {
  for (std::size_t i = 0; i < grid.columns; ++i) {
    for (std::size_t k = 0; k < grid.rows; ++k) {
      grid.velocity[2 * grid.index(i, k)] = rate * (static_cast<double>(k) - 1) * grid.h;
    }
  }
}

double mean(const std::vector<double>& values, std::size_t count) {
  return std::accumulate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count), 0.0) /
         static_cast<double>(count);
}

DssPoint state(const Particles& p, double strain) {
  return {strain, mean(p.sxz, p.count), mean(p.plastic_strain, p.count)};
}

/// Small enough that strength, which is taken at the start of a step, lags by a five hundredth of
/// the peak at most; larger once the exponential is spent.
double step_of(const SofteningCurve& law, double plastic_strain) {
  const bool spent = law.rate > 0 && plastic_strain > 20 / law.rate;
  const double loss = steepest_loss(law);
  if (spent || loss <= 0) return coarse_step;
  return std::min(coarse_step, loss_a_step * law.peak / loss);
}

bool worth_keeping(const DssPoint& now, const DssPoint& kept, double peak_Pa) {
  return std::abs(now.stress_Pa - kept.stress_Pa) > change_a_point * peak_Pa ||
         now.strain > stretch_a_point * kept.strain + coarse_step;
}

}  // namespace

DssCurve dss_of_particles(const Material& material, double peak_Pa, const ParticleShear& test) {
  const LawTable laws = law_of(material, peak_Pa, test.cell_m);
  const SofteningCurve law = material.softening ? laws.curve(0) : perfectly_plastic(peak_Pa);
  const double end = test.max_strain.value_or(default_max_strain(law, material.shear_modulus_Pa));
  Particles particles = specimen(material, test);
  Grid grid = make_grid(test.cell_m, 3 * test.cell_m, 3 * test.cell_m);
  if (!sort_particles(particles, grid)) throw std::logic_error("a specimen outside its grid");
  move_nodes(grid, test.rate);
  DssCurve curve{.height_m = test.cell_m,
                 .points = {state(particles, 0)},
                 .snaps_back = steepest_loss(law) > material.shear_modulus_Pa};
  DssPoint now = curve.points.back();
  while (now.strain < end) {
    const double step = std::min(step_of(law, now.plastic_strain), end - now.strain);
    grid_to_particles(particles, grid, laws, step / test.rate, false);
    now = state(particles, now.strain + step);
    if (end - now.strain < 1e-12 * end) now.strain = end;
    if (now.strain >= end || worth_keeping(now, curve.points.back(), peak_Pa)) {
      curve.points.push_back(now);
    }
  }
  return curve;
}

}  // namespace leda::solver
