// Softening over a band of its own thickness: a layer of clay sheared from above until it has
// slipped, its stress against the law over the slip, whatever the cell.
#include "solver/kernel/band.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <vector>

#include "tests/solver/block.hpp"
#include "tests/verification/record.hpp"

namespace leda::solver::test {
namespace {

constexpr double band = 2, height = 10, length = 40;   // m
constexpr double peak = 40e3, remolded = 5e3;          // Pa
constexpr double specimen = 0.024, slip_scale = 0.06;  // m: the loss over it is that of exp(-1)
constexpr double end = 0.30;                           // m of slip

Section clay() {
  Section s;
  Material& m = s.materials["clay"];
  m.unit_weight = 17e3;
  m.shear_modulus_Pa = 4e6;
  m.poisson_ratio = 0.45;
  m.peak_strength.constant_Pa = peak;
  m.softening = Softening{ExponentialSoftening{remolded, specimen / slip_scale}, specimen,
                          Regularization::band, band};
  s.materials["weak"] = m;  // by 2 %, where the slip begins
  s.materials["weak"].peak_strength.constant_Pa = 0.98 * peak;
  return s;
}

struct State {
  double slip, stress;  ///< m, Pa
};

template <class Real>
struct Sheared {
  Model<Real> model;
  ThreadTeam team{1};
  double h, dt;

  // The layer stands free at both ends of a wider grid, sheared by the rows of nodes above it.
  explicit Sheared(double cell) : model(layer(cell)), h(cell) { dt = 0.4 * h / speed_of(clay()); }

  static double speed_of(const Section& s) {
    LawTableBuilder builder(s, 1);
    builder.row(0, 0, 0);
    return builder.table().stiffest_speed;
  }

  static Model<Real> layer(double cell) {
    const Section section = clay();
    LawTableBuilder laws(section, cell);
    laws.row(0, 0, 0);
    laws.row(1, 0, 0);
    Block<Real> block(cell, length + 8 * cell, height + 4 * cell, 4 * cell, 0, length, height, {});
    block.laws = laws.table();
    for (Particle& p : block.particles) {
      p.mass = 17e3 / gravity * p.volume;
      // A band of rows, as wide for every cell.
      p.law = std::abs(p.z - height / 2) < band / 4 ? 1 : 0;
    }
    return block.model();
  }

  void step(double speed) {
    const StepSettings settings{dt, 0, 0.1, true};
    balance_nodes(model, settings, team);
    const auto first = static_cast<std::size_t>(std::lround(height / h));  // the row of the top
    for (std::size_t i = 0; i < model.grid.columns; ++i) {
      for (std::size_t k = first; k < model.grid.rows; ++k) {
        *model.grid.velocity_at(i, k) = static_cast<Real>(speed);
        *(model.grid.velocity_at(i, k) + model.grid.stride) = 0;
      }
    }
    average_band(model, team);
    const PointSums sums = move_points(model, settings, false, team);
    model.yielded.assign(model.yielded.size(), sums.yields ? 1 : 0);
  }

  // Over the middle third of the layer, away from its ends.
  double stress() const {
    double force = 0, volume = 0;
    for (const Particle& p : unpack(model.packs, h)) {
      if (std::abs(p.x - 4 * h - length / 2) > length / 6) continue;
      force += p.volume * p.sxz;
      volume += p.volume;
    }
    return force / volume;
  }
};

template <class Real>
std::vector<State> shear(double cell) {
  Sheared<Real> layer(cell);
  std::vector<State> states;
  const double shear_modulus = 4e6;
  double moved = 0, speed = 0;
  for (int i = 1; moved < end + 2 * height * peak / shear_modulus; ++i) {
    speed = std::min(0.01, speed + 0.01 * layer.dt);  // in a second
    layer.step(speed);
    moved += speed * layer.dt;
    if (i % 10 == 0) {
      EXPECT_TRUE(tidy_up(layer.model));
    }
    if (i % 100 != 0) continue;
    const double stress = layer.stress();
    states.push_back({moved - stress * (height - 1.5 * layer.h) / shear_modulus, stress});
    if (states.back().slip > end) break;
  }
  return states;
}

template <class Real>
class Band : public ::testing::Test {};
TYPED_TEST_SUITE(Band, BothPrecisions, PrecisionNames);

// The work of a slip is that of the law measured on the specimen, for cells from half of the band
// to a sixth. What is sheared at 0.01 m/s takes 5 to 8 % more, which falls with the speed
// (1.15, 1.05, 1.02, 1.00 at 0.004 m/s); at half of the band the splines alone spread a slip over
// more than it.
TYPED_TEST(Band, WorkOfASlipIsThatOfTheSpecimenWhateverTheCell) {
  const double specimens =
      remolded * end + (peak - remolded) * slip_scale * (1 - std::exp(-end / slip_scale));
  std::string text;
  for (const auto& [cells, tolerance] :
       {std::pair(2.0, 0.20), std::pair(3.0, 0.12), std::pair(4.0, 0.12), std::pair(6.0, 0.12)}) {
    const auto states = shear<TypeParam>(band / cells);
    double work = 0;
    for (std::size_t i = 1; i < states.size(); ++i) {
      work +=
          0.5 * (states[i].stress + states[i - 1].stress) * (states[i].slip - states[i - 1].slip);
    }
    EXPECT_NEAR(work / specimens, 1, tolerance) << "cells of band / " << cells;
    EXPECT_NEAR(states.back().stress, remolded, 0.05 * peak) << "cells of band / " << cells;
    std::ostringstream one;
    one.precision(3);
    one << (text.empty() ? "" : ", ") << work / specimens;
    text += one.str();
  }
  leda::test::record(text, " of the specimen's work, cells of band / 2, 3, 4, 6");
}

}  // namespace
}  // namespace leda::solver::test
