// What the initial stress costs, by static solves and by the relaxation they replace. The argument
// is the peak strength in kPa: at 45 the bank stands, at 27 it finds no balance and both relax.

#include <benchmark/benchmark.h>

#include "solver/run/initial_stress.hpp"
#include "tests/bench/sliding_bank.hpp"

namespace {

using namespace leda::solver;

void find_it(benchmark::State& state, QuietMethod method) {
  bench::Bank bank;
  const double strength = 1e3 * static_cast<double>(state.range(0));
  bank.section.materials.at("clay").peak_strength.constant_Pa = strength;
  for (auto _ : state) {
    state.PauseTiming();
    RunState run = bank.start();
    state.ResumeTiming();
    if (find_initial_stress(run, method)) state.SkipWithError("the stage did not end well");
    state.counters["particles"] = static_cast<double>(
        with_model(run.model, [](const auto& model) { return model.packs.count; }));
    state.counters["steps"] = static_cast<double>(run.steps);
  }
}

void initial_stress_direct(benchmark::State& state) { find_it(state, QuietMethod::direct); }
BENCHMARK(initial_stress_direct)->Arg(45)->Arg(27)->Iterations(1)->Unit(benchmark::kMillisecond);

void initial_stress_relaxed(benchmark::State& state) { find_it(state, QuietMethod::relaxed); }
BENCHMARK(initial_stress_relaxed)->Arg(45)->Arg(27)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
