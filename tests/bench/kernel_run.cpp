// A short run that is always the same, for count_instructions.sh: steps of the packs and of the
// double reference on a bank that gives way at once. Prints how often each part was called for how
// many points, as lines "name,count".

#include <cstddef>
#include <cstdio>

#include "solver/kernel/packed_stage.hpp"
#include "solver/kernel/sort_particles.hpp"
#include "solver/kernel/time_step.hpp"
#include "solver/run/seed_particles.hpp"
#include "tests/solver/bank.hpp"

namespace {

using namespace leda::solver;

constexpr int packed_steps = 600;  // 2.4 s: elastic waves, yield and points that leave their cells
constexpr int reference_steps = 60;
constexpr int steps_between_sorts = 16;
constexpr int rehomings = 4;

StepSettings settings_of(const Seeded& seeded) {
  constexpr double fastest = 3.0, factor = 0.5, damping = 0.02;
  return {time_step(seeded.grid.h, seeded.laws.stiffest_speed, fastest, factor), leda::gravity,
          damping, true};
}

bool run_packs(const Seeded& seeded) {
  auto stage = begin_packed_stage(seeded.particles, seeded.grid, seeded.laws);
  if (!stage) return false;
  const StepSettings settings = settings_of(seeded);
  Team team(1);
  bool left_grid = false;
  for (int i = 0; i < packed_steps && !left_grid; ++i) {
    // At fixed steps, so that the number of calls does not hang on the rule for when.
    if (i % (packed_steps / rehomings) == 0) {
      if (!tidy_up(*stage)) return false;
    }
    step(*stage, settings, false, team, left_grid);
  }
  return !left_grid;
}

bool run_reference(Seeded seeded) {
  const StepSettings settings = settings_of(seeded);
  for (int i = 0; i < reference_steps; ++i) {
    if (i % steps_between_sorts == 0 && !sort_particles(seeded.particles, seeded.grid)) {
      return false;
    }
    step(seeded.particles, seeded.grid, seeded.laws, settings);
  }
  return true;
}

}  // namespace

int main() {
  const Seeded seeded = seed_particles(test::bank(12, 40, 15e3), test::coarse().resolution);
  if (!run_packs(seeded) || !run_reference(seeded)) {
    std::fprintf(stderr, "kernel_run: a point left the grid\n");
    return 1;
  }
  std::printf("points,%zu\npacked_steps,%d\nreference_steps,%d\nrehomings,%d\n",
              seeded.particles.count, packed_steps, reference_steps, rehomings);
  return 0;
}
