#pragma once
// A rectangular block of particles of one elastic or Tresca material, for tests of the step.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "solver/kernel/model.hpp"
#include "solver/kernel/pack_particles.hpp"
#include "tests/solver/precisions.hpp"

namespace leda::solver::test {

struct BlockMaterial {
  double youngs_modulus = 1e6, poisson_ratio = 0.3, density = 1000;
  double peak = 1e30;  ///< s_up, Pa
};

inline LawTable one_law(const BlockMaterial& m) {
  const double endless = std::numeric_limits<double>::infinity();
  LawTable t;
  t.bulk = {m.youngs_modulus / (3 * (1 - 2 * m.poisson_ratio))};
  t.shear = {m.youngs_modulus / (2 * (1 + m.poisson_ratio))};
  t.peak = t.floor = {m.peak};
  t.amplitude = t.rate = t.line_start = t.line_slope = t.last = {0.0};
  t.exp_end = t.line_end = {endless};
  t.softens = t.material = {0};
  t.stiffest_speed = std::sqrt((t.bulk[0] + 4.0 / 3.0 * t.shear[0]) / m.density);
  return t;
}

/// Particles per_side x per_side a cell over [x0, x0 + length] x [z0, z0 + height].
template <class Real = double>
struct Block {
  Particles particles;  ///< in the order of their ids, column by column
  Particles start;      ///< as they were seeded
  GridSize size;
  LawTable laws;
  ModelSettings settings;

  Block(double h, double model_length, double model_height, double x0, double z0, double length,
        double height, const BlockMaterial& material, int per_side = 2)
      : size(grid_over(h, model_length, model_height)), laws(one_law(material)) {
    const double spacing = h / per_side;
    const auto columns = std::lround(length / spacing), rows = std::lround(height / spacing);
    for (long i = 0; i < columns; ++i) {
      for (long j = 0; j < rows; ++j) {
        Particle p;
        p.x = x0 + (static_cast<double>(i) + 0.5) * spacing;
        p.z = z0 + (static_cast<double>(j) + 0.5) * spacing;
        p.mass = material.density * spacing * spacing;
        p.volume = spacing * spacing;
        p.id = static_cast<std::int32_t>(particles.size());
        particles.push_back(p);
      }
    }
    start = particles;
    settings.rests = false;
  }

  double time_step(double factor = 0.4) const { return factor * size.h / laws.stiffest_speed; }

  Model<Real> model() const {
    auto made = make_model<Real>(particles, size, laws, settings);
    EXPECT_TRUE(made);
    return std::move(*made);
  }

  /// `look`, where there is one, sees the particles after every step.
  void run(int steps, const StepSettings& step_settings,
           const std::function<void(int)>& look = nullptr) {
    Model<Real> m = model();
    ThreadTeam team(1);
    for (int i = 1; i <= steps; ++i) {
      if (i % 10 == 0) {
        ASSERT_TRUE(tidy_up(m));
      }
      step(m, step_settings, look || i == steps, team);
      if (!look) continue;
      particles = unpack(m.packs, size.h);
      look(i);
    }
    particles = unpack(m.packs, size.h);
  }
};

/// A block whose nodes are moved by hand, past the momentum balance; its points do not move.
template <class Real = double>
struct Element {
  Model<Real> model;
  ThreadTeam team{1};

  explicit Element(const Block<Real>& block) : model(block.model()) {}

  /// Velocity of every node by its place, m/s.
  template <class Field>
  PointSums strain(double dt, const Field& velocity) {
    for (std::size_t i = 0; i < model.grid.columns; ++i) {
      for (std::size_t k = 0; k < model.grid.rows; ++k) {
        const auto [vx, vz] = velocity((static_cast<double>(i) - 1) * model.grid.h,
                                       (static_cast<double>(k) - 1) * model.grid.h);
        *model.grid.velocity_at(i, k) = static_cast<Real>(vx);
        *(model.grid.velocity_at(i, k) + model.grid.stride) = static_cast<Real>(vz);
      }
    }
    const PointSums sums = move_points(model, {dt, 0, 0, false}, true, team);
    std::ranges::fill(model.grid.sums, Real{0});
    return sums;
  }

  /// A uniform velocity gradient.
  PointSums strain(double lxx, double lxz, double lzx, double lzz, double dt) {
    return strain(
        dt, [&](double x, double z) { return std::pair(lxx * x + lxz * z, lzx * x + lzz * z); });
  }

  /// The same in every point, without shear in the plane, Pa.
  void set_stress(double sxx, double szz, double syy) {
    for (auto& pack : model.packs.pack) {
      std::ranges::fill(pack.sxx, static_cast<Real>(sxx));
      std::ranges::fill(pack.szz, static_cast<Real>(szz));
      std::ranges::fill(pack.syy, static_cast<Real>(syy));
      std::ranges::fill(pack.sxz, Real{0});
    }
  }

  Particles particles() const { return unpack(model.packs, model.grid.h); }
};

}  // namespace leda::solver::test
