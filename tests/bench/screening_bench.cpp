// What screening costs: one section, and a region of 500.

#include <benchmark/benchmark.h>

#include "solver/screening/decide.hpp"
#include "tests/validation/generated_sections.hpp"

namespace {

using namespace leda;

constexpr std::uint64_t region_size = 500;

test::GeneratedCase nth(std::uint64_t i) { return test::generate_case(1 + i % region_size, 10); }

void undrained_bishop_of_a_section(benchmark::State& state) {
  std::uint64_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    const test::GeneratedCase c = nth(i++);
    state.ResumeTiming();
    benchmark::DoNotOptimize(solver::undrained_bishop(c.section, c.section.ground));
  }
}
BENCHMARK(undrained_bishop_of_a_section)->Unit(benchmark::kMillisecond);

void decision_of_a_section(benchmark::State& state) {
  std::uint64_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    const test::GeneratedCase c = nth(i++);
    state.ResumeTiming();
    benchmark::DoNotOptimize(solver::screen_quickly(c.section, c.settings));
  }
}
BENCHMARK(decision_of_a_section)->Unit(benchmark::kMillisecond);

void everything_of_a_section(benchmark::State& state) {
  std::uint64_t i = 0;
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    const test::GeneratedCase c = nth(i++);
    state.ResumeTiming();
    benchmark::DoNotOptimize(solver::screen(c.section, c.settings));
  }
}
BENCHMARK(everything_of_a_section)->Unit(benchmark::kMillisecond);

void decision_of_a_region_of_500(benchmark::State& state) {
  for ([[maybe_unused]] auto _ : state) {
    for (std::uint64_t i = 0; i < region_size; ++i) {
      const test::GeneratedCase c = nth(i);
      benchmark::DoNotOptimize(solver::screen_quickly(c.section, c.settings));
    }
  }
}
BENCHMARK(decision_of_a_region_of_500)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
