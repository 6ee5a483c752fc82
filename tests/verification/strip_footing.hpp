#pragma once
// A rigid rough strip pushed into weightless clay: the indentation pressure over s_u.

#include <cmath>

#include "solver/section/run_settings.hpp"
#include "tests/solver/block.hpp"

namespace leda::solver::test {

struct Footing {
  int cells = 8;  ///< under half the strip
  double poisson_ratio = 0.45;
  double settlement = 0.08;  ///< of the strip's half width
  double time_step_factor = 0.4;
};

/// The nodes on and above the ground under the strip.
struct StripNodes {
  std::size_t surface_row, last_column;

  /// Vertical force that the ground has on them.
  template <class Real>
  double force(Grid<Real>& grid) const {
    double sum = 0;
    for (std::size_t i = 1; i <= last_column; ++i) {
      for (std::size_t row = surface_row; row < grid.top[i]; ++row) {
        sum += static_cast<double>(*(grid.force_at(i, row) + grid.stride));
      }
    }
    return sum;
  }

  /// Moves them down, m/s; column 0 has the images of the symmetry.
  template <class Real>
  void move(Grid<Real>& grid, double speed) const {
    for (std::size_t i = 0; i <= last_column; ++i) {
      for (std::size_t row = surface_row; row < grid.top[i]; ++row) {
        *grid.velocity_at(i, row) = 0;
        *(grid.velocity_at(i, row) + grid.stride) = static_cast<Real>(-speed);
      }
    }
  }
};

/// Half the strip by symmetry (a side without friction), width 2 m, s_u = 1000 Pa; 4 m of clay to
/// the side and 2.5 m below. Positions are held, so the answer is that of small strain. The nodes
/// on and above the surface under the strip move down at a constant speed; what they carry is the
/// sum of their internal forces. Between the last node of the strip and its free neighbour the
/// velocity falls from one to nothing, so the strip ends half a cell beyond that node.
template <class Real>
double bearing_capacity_factor(const Footing& f) {
  const double strength = 1000, half_width = 1, depth = 2.5, width = 5;
  const double h = half_width / (f.cells + 0.5);
  const double top = h * std::ceil(depth / h), length = h * std::ceil(width / h);
  const double shear = 200 * strength;
  Block<Real> b(h, length, top + 4 * h, 0, 0, length, top,
                {2 * shear * (1 + f.poisson_ratio), f.poisson_ratio, 1000, strength});
  b.settings.keeps_force = true;
  b.settings.averages = nearly_incompressible(b.laws);
  b.settings.softer = f.time_step_factor > most_factor_unsoftened;
  const StripNodes strip{static_cast<std::size_t>(std::lround(top / h)) + 1,
                         static_cast<std::size_t>(f.cells) + 1};
  // Slow against the shear wave: what the ground's inertia adds falls with the speed (README.md).
  const double dt = b.time_step(f.time_step_factor), speed = 1.65e-4 * std::sqrt(shear / 1000);
  const int steps = static_cast<int>(f.settlement * half_width / speed / dt);
  const StepSettings settings{dt, 0.0, 0.5, false};
  Model<Real> model = b.model();
  ThreadTeam team(1);
  const double share = 0.01 * f.time_step_factor / 0.4;  // waves pass: a mean over about 100 steps
  double largest = 0, recent = 0;
  for (int k = 0; k < steps; ++k) {
    balance_nodes(model, settings, team);
    const double force = strip.force(model.grid);
    strip.move(model.grid, speed);
    move_points(model, settings, false, team);
    recent += share * (force - recent);
    largest = std::max(largest, recent);
  }
  return largest / half_width / strength;
}

}  // namespace leda::solver::test
