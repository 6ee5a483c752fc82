#pragma once
// How a section is run: resolution, trigger, damping, stop, output. SI units.

#include <cstdint>
#include <optional>
#include <variant>

#include "solver/section/engine.hpp"
#include "solver/section/geometry.hpp"

namespace leda {

struct Resolution {
  double cell_m = 1.0;
  int particles_per_cell = 4;  ///< a square: 1, 4, 9, 16
  std::uint64_t seed = 0;      ///< 0: a regular lattice; else particles are moved by up to 1e-6 m
};

/// Softening is switched on. If the section then stays at rest and a cut is given, a vertical
/// face of that height is cut at the toe: all ground in front of it above the toe is removed.
struct UndrainedTrigger {
  std::optional<double> then_toe_cut_m;
};

/// Softening is switched on and the ground inside the polygon is removed.
struct ExcavationTrigger {
  Polyline polygon;
};

using Trigger = std::variant<UndrainedTrigger, ExcavationTrigger>;

/// Local (Cundall) damping: a force against motion, this fraction of the unbalanced force.
struct Damping {
  double initial = 0.75;  ///< thesis 4.5
  double dynamic = 0.02;  ///< thesis 4.5
};

struct Stop {
  double max_time_s = 120;
};

struct Output {
  double frame_interval_s = 0;  ///< 0: the first and the last state only
  bool paraview = false;        ///< also view.pvd and VTU
};

struct RunSettings {
  Resolution resolution;
  Trigger trigger = UndrainedTrigger{};
  Damping damping;
  double time_step_factor = 0.65;  ///< of h / c_p; 1 is stable in all of leda check
  Stop stop;
  Output output;
  Precision precision = Precision::single_precision;  ///< of the moving stage
  bool ground_rests = true;  ///< ground that has come to rest is not stepped
};

/// The longest step, of h / c_p, that ground as it is can take: 0.7 was stable in all of leda
/// check.
inline constexpr double most_factor_unsoftened = 0.65;

/// Whether steps are so long that ground which would limit them has to be softer
/// (solver/kernel/softer-inl.hpp).
inline bool takes_long_steps(const RunSettings& settings) {
  return settings.time_step_factor > most_factor_unsoftened;
}

}  // namespace leda
