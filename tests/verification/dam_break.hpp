#pragma once
// A column of nearly strengthless fluid that is let go.

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/solver/block.hpp"

namespace leda::solver::test {

struct DamBreak {
  double width = 1, height = 1;  ///< of the column, m
  double room = 5;               ///< to the right of it, m
  double cell = 0.05;
};

/// Water: rho = 1000 kg/m3, bulk modulus for a speed of sound of 20 sqrt(g H), so that density
/// stays within about 1 %; a shear modulus of a thousandth of it, and a strength that carries a
/// thousandth of the column's weight.
class Fluid {
 public:
  static constexpr double g = 9.81, density = 1000;

  explicit Fluid(const DamBreak& d)
      : block_(d.cell, d.width + d.room, 1.5 * d.height, 0, 0, d.width, d.height, {}, 2) {
    const double sound = 20 * std::sqrt(g * d.height), bulk = density * sound * sound;
    LawTable& t = block_.laws;
    t.bulk = {bulk};
    t.shear = {1e-3 * bulk};
    t.peak = t.floor = {1e-3 * density * g * d.height};
    t.stiffest_speed = std::sqrt((bulk + 4.0 / 3.0 * t.shear[0]) / density);
    Particles& p = block_.particles;
    for (std::size_t i = 0; i < p.count; ++i) {
      p.sxx[i] = p.szz[i] = p.syy[i] = -density * g * (d.height - p.z[i]);
    }
  }

  double advance() {
    if (count_++ % 5 == 0) sort_particles(block_.particles, block_.grid);
    const double dt = block_.time_step();
    step(block_.particles, block_.grid, block_.laws, {dt, g, 0.0, true});
    return dt;
  }

  /// Where only the given area of fluid, m2, lies ahead: the tip itself breaks into drops.
  double front(double ahead) const {
    const Particles& p = block_.particles;
    std::vector<double> x(p.x.begin(), p.x.begin() + static_cast<std::ptrdiff_t>(p.count));
    const auto drops = static_cast<std::ptrdiff_t>(ahead * density / p.mass[0]);
    std::nth_element(x.begin(), x.end() - 1 - drops, x.end());
    return *(x.end() - 1 - drops);
  }

  /// Fluid standing over x, m: mass of a strip of two cells over its width and density.
  double depth(double x) const {
    const Particles& p = block_.particles;
    double mass = 0;
    for (std::size_t i = 0; i < p.count; ++i) {
      if (std::abs(p.x[i] - x) < block_.grid.h) mass += p.mass[i];
    }
    return mass / density / (2 * block_.grid.h);
  }

 private:
  Block block_;
  int count_ = 0;
};

}  // namespace leda::solver::test
