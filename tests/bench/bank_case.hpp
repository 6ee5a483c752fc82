#pragma once
// The ways in which a step is measured: what the clay's law holds, how nearly incompressible it is,
// and how long the steps are.

#include "solver/kernel/model.hpp"
#include "solver/kernel/time_step.hpp"
#include "solver/run/seed_particles.hpp"

namespace leda::solver::bench {

struct BankCase {
  const char* name;
  double poisson_ratio = 0.45;  ///< above 0.46 dilation is averaged
  bool rated = false;           ///< strength depends on the rate of shear
  double time_step_factor = 0.5;

  /// The same section with clay of this case.
  Section of(Section section) const {
    for (auto& [name_of, clay] : section.materials) {
      clay.poisson_ratio = poisson_ratio;
      if (rated) clay.rate = PowerRate{0.08, 1e-4};
    }
    return section;
  }

  ModelSettings model_settings(const Seeded& seeded) const {
    return {.softer = time_step_factor > most_factor_unsoftened,
            .averages = seeded.averages,
            .keeps_force = false,
            .rests = false};
  }

  StepSettings step_settings(const Seeded& seeded) const {
    constexpr double fastest = 3.0, damping = 0.02;
    return {time_step(seeded.size.h, seeded.laws.stiffest_speed, fastest, time_step_factor),
            gravity, damping, true};
  }
};

inline constexpr BankCase bank_cases[] = {{.name = "plain"},
                                          {.name = "rate", .rated = true},
                                          {.name = "averaged", .poisson_ratio = 0.49},
                                          {.name = "long", .time_step_factor = 0.95}};

}  // namespace leda::solver::bench
