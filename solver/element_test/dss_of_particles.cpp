#include "solver/element_test/dss_of_particles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "solver/element_test/dissipation.hpp"
#include "solver/kernel/model.hpp"

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
  Particles particles;
  for (int i = 0; i < side * side; ++i) {
    Particle p;
    p.x = test.cell_m + (i / side + 0.5) * spacing;
    p.z = test.cell_m + (i % side + 0.5) * spacing;
    p.volume = spacing * spacing;
    p.mass = p.volume * material.unit_weight / gravity;
    p.szz = -test.vertical_stress_Pa;
    p.sxx = p.syy = -material.k0 * test.vertical_stress_Pa;
    p.id = i;
    particles.push_back(p);
  }
  return particles;
}

/// Simple shear at every node: v_x = rate z, v_z = 0.
void move_nodes(Grid<double>& grid, double rate) {
  for (std::size_t i = 0; i < grid.columns; ++i) {
    for (std::size_t k = 0; k < grid.rows; ++k) {
      *grid.velocity_at(i, k) = rate * (static_cast<double>(k) - 1) * grid.h;
    }
  }
}

DssPoint state(const Packs<double>& packs, double strain) {
  DssPoint mean{strain, 0, 0};
  for_each_point(packs, [&](std::size_t i, std::size_t l) {
    mean.stress_Pa += packs.pack[i].sxz[l] / static_cast<double>(packs.count);
    mean.plastic_strain += packs.pack[i].plastic_strain[l] / static_cast<double>(packs.count);
  });
  return mean;
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
  auto model = make_model<double>(specimen(material, test),
                                  grid_over(test.cell_m, 3 * test.cell_m, 3 * test.cell_m), laws);
  if (!model) throw std::logic_error("a specimen outside its grid");
  ThreadTeam team(1);
  move_nodes(model->grid, test.rate);
  DssCurve curve{.height_m = test.cell_m,
                 .points = {state(model->packs, 0)},
                 .snaps_back = steepest_loss(law) > material.shear_modulus_Pa};
  DssPoint now = curve.points.back();
  while (now.strain < end) {
    const double step = std::min(step_of(law, now.plastic_strain), end - now.strain);
    move_points(*model, {step / test.rate, 0, 0, false}, false, team);
    std::ranges::fill(model->grid.sums, 0.0);  // nothing of them is used
    now = state(model->packs, now.strain + step);
    if (end - now.strain < 1e-12 * end) now.strain = end;
    if (now.strain >= end || worth_keeping(now, curve.points.back(), peak_Pa)) {
      curve.points.push_back(now);
    }
  }
  return curve;
}

}  // namespace leda::solver
