#pragma once
// A column of nearly strengthless fluid that is let go.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/solver/block.hpp"

namespace leda::solver::test {

struct Dam {
  double width = 1, height = 1;  ///< of the column, m
  double room = 5;               ///< to the right of it, m
  double cell = 0.05;
};

/// Water: rho = 1000 kg/m3, bulk modulus for a speed of sound of 20 sqrt(g H), so that density
/// stays within about 1 %; a shear modulus of a thousandth of it, and a strength that carries a
/// thousandth of the column's weight; no tension.
template <class Real>
class Fluid {
 public:
  static constexpr double g = 9.81, density = 1000;

  explicit Fluid(const Dam& d) : cell_(d.cell) {
    Block<Real> block(d.cell, d.width + d.room, 1.5 * d.height, 0, 0, d.width, d.height, {}, 2);
    const double sound = 20 * std::sqrt(g * d.height), bulk = density * sound * sound;
    LawTable& t = block.laws;
    t.bulk = {bulk};
    t.shear = {1e-3 * bulk};
    t.peak = t.floor = {1e-3 * density * g * d.height};
    t.tension = {0};
    t.stiffest_speed = std::sqrt((bulk + 4.0 / 3.0 * t.shear[0]) / density);
    for (Particle& p : block.particles) {
      p.sxx = p.szz = p.syy = -density * g * (d.height - p.z);
    }
    dt_ = block.time_step();
    model_ = block.model();
  }

  double advance() {
    if (count_++ % 5 == 0) {
      EXPECT_TRUE(tidy_up(model_));
    }
    EXPECT_FALSE(step(model_, {dt_, g, 0.0, true}, false, team_).points.left_grid);
    return dt_;
  }

  /// Where only the given area of fluid, m2, lies ahead: the tip itself breaks into drops.
  double front(double ahead) const {
    std::vector<double> x;
    double mass = 0;
    for_each_point(model_.packs, [&](std::size_t i, std::size_t l) {
      x.push_back(point_at(model_.packs, i, l, cell_).x);
      mass = static_cast<double>(model_.packs.pack[i].mass[l]);
    });
    const auto drops = static_cast<std::ptrdiff_t>(ahead * density / mass);
    std::nth_element(x.begin(), x.end() - 1 - drops, x.end());
    return *(x.end() - 1 - drops);
  }

  /// Fluid standing over x, m: mass of a strip of two cells over its width and density.
  double depth(double x) const {
    double mass = 0;
    for_each_point(model_.packs, [&](std::size_t i, std::size_t l) {
      if (std::abs(point_at(model_.packs, i, l, cell_).x - x) >= cell_) return;
      mass += static_cast<double>(model_.packs.pack[i].mass[l]);
    });
    return mass / density / (2 * cell_);
  }

 private:
  double cell_, dt_ = 0;
  Model<Real> model_;
  ThreadTeam team_{1};
  int count_ = 0;
};

}  // namespace leda::solver::test
