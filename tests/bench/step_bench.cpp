// The step of the solver and its parts, packed and by the double reference, on one bank that still
// stands and on the same bank five seconds into its slide. Times are of the processor, a particle
// and step, ns.

#include <benchmark/benchmark.h>

#include <ctime>

#include "solver/kernel/packed_stage.hpp"
#include "solver/kernel/sort_particles.hpp"
#include "solver/kernel/time_step.hpp"
#include "solver/run/initial_stress.hpp"
#include "tests/bench/sliding_bank.hpp"

namespace {

using namespace leda::solver;
using leda::gravity;

constexpr double damping = 0.02;
constexpr int steps_between_sorts = 16;

// Calls part() each iteration with its own processor time, which other work on the machine disturbs
// less than the wall clock; the rest of a step stands outside of it.
class Timer {
 public:
  explicit Timer(benchmark::State& state) : state_(state) {}
  template <class Part, class Rest>
  void run(double particles, const Part& part, const Rest& rest) {
    for (auto _ : state_) {
      const std::clock_t began = std::clock();
      part();
      const double took = static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
      state_.SetIterationTime(took);
      seconds_ += took;
      rest();
    }
    const auto steps = static_cast<double>(state_.iterations());
    state_.counters["ns_per_particle"] = 1e9 * seconds_ / (steps * particles);
    state_.counters["particles"] = particles;
  }

 private:
  benchmark::State& state_;
  double seconds_ = 0;
};

StepSettings settings_of(const Seeded& seeded) {
  return {time_step(seeded.grid.h, seeded.laws.stiffest_speed, 3.0, 0.5), gravity, damping, true};
}

void update_all(PackedStage& stage, const StepSettings& settings) {
  update_columns(stage.grid, {settings.dt, settings.gravity, settings.damping}, 1,
                 stage.grid.columns - 1);
}

void update_points(PackedStage& stage, double dt) {
  for (const PackGroup& group : stage.packs.group) {
    stage.strayed +=
        step_packs(stage.packs, stage.grid, stage.laws, dt, false, group.first, group.end())
            .strayed;
  }
}

void reference_step(benchmark::State& state) {
  Seeded s = bench::bank_after(static_cast<double>(state.range(0)));
  const StepSettings settings = settings_of(s);
  int since = 0;
  Timer(state).run(
      static_cast<double>(s.particles.count),
      [&] {
        if (since++ % steps_between_sorts == 0) sort_particles(s.particles, s.grid);
        benchmark::DoNotOptimize(step(s.particles, s.grid, s.laws, settings));
      },
      [] {});
}
BENCHMARK(reference_step)->Arg(0)->Arg(5)->UseManualTime();

void packed_step(benchmark::State& state) {
  const Seeded s = bench::bank_after(static_cast<double>(state.range(0)));
  auto stage = begin_packed_stage(s.particles, s.grid, s.laws);
  const StepSettings settings = settings_of(s);
  Team team(1);
  bool left = false;
  Timer(state).run(
      static_cast<double>(s.particles.count),
      [&] {
        if (is_untidy(*stage)) tidy_up(*stage);
        benchmark::DoNotOptimize(step(*stage, settings, false, team, left));
      },
      [] {});
  std::size_t packs = 0;
  for (const PackGroup& group : stage->packs.group) packs += group.in_use;
  state.counters["points_per_pack"] =
      static_cast<double>(stage->packs.count) / static_cast<double>(packs);
}
BENCHMARK(packed_step)->Arg(0)->Arg(5)->UseManualTime();

void packed_points(benchmark::State& state) {
  const Seeded s = bench::bank_after(static_cast<double>(state.range(0)));
  auto stage = begin_packed_stage(s.particles, s.grid, s.laws);
  const StepSettings settings = settings_of(s);
  const auto nodes = [&] {
    update_all(*stage, settings);
    if (is_untidy(*stage)) tidy_up(*stage);
  };
  nodes();
  Timer(state).run(
      static_cast<double>(s.particles.count), [&] { update_points(*stage, settings.dt); }, nodes);
}
BENCHMARK(packed_points)->Arg(0)->Arg(5)->UseManualTime();

void packed_nodes(benchmark::State& state) {
  const Seeded s = bench::bank_after(0);
  auto stage = begin_packed_stage(s.particles, s.grid, s.laws);
  const StepSettings settings = settings_of(s);
  Timer(state).run(
      static_cast<double>(s.particles.count), [&] { update_all(*stage, settings); },
      [&] { update_points(*stage, settings.dt); });
}
BENCHMARK(packed_nodes)->UseManualTime();

void packing(benchmark::State& state) {
  const Seeded s = bench::bank_after(5);
  auto stage = begin_packed_stage(s.particles, s.grid, s.laws);
  Timer(state).run(
      static_cast<double>(s.particles.count), [&] { pack(s.particles, stage->grid, stage->packs); },
      [] {});
}
BENCHMARK(packing)->UseManualTime();

void rehoming(benchmark::State& state) {
  const Seeded s = bench::bank_after(5);
  auto stage = begin_packed_stage(s.particles, s.grid, s.laws);
  const StepSettings settings = settings_of(s);
  Timer(state).run(
      static_cast<double>(s.particles.count), [&] { tidy_up(*stage); },
      [&] {
        update_all(*stage, settings);
        update_points(*stage, settings.dt);
      });
}
BENCHMARK(rehoming)->UseManualTime();

void unpacking(benchmark::State& state) {
  Seeded s = bench::bank_after(5);
  const auto stage = begin_packed_stage(s.particles, s.grid, s.laws);
  Timer(state).run(
      static_cast<double>(s.particles.count),
      [&] { unpack(stage->packs, stage->grid, s.particles); }, [] {});
}
BENCHMARK(unpacking)->UseManualTime();

}  // namespace
