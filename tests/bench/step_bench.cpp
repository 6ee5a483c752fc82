// The step of the solver and its parts, on a bank that still stands and on the same bank five
// seconds into its slide: in both precisions, with AVX2 too where the processor has more, and for
// each of bank_cases. Times are of the processor, a particle and step, ns.

#include <benchmark/benchmark.h>

#include <ctime>
#include <string>
#include <vector>

#include "solver/kernel/pack_particles.hpp"
#include "tests/bench/instruction_set.hpp"
#include "tests/bench/sliding_bank.hpp"

namespace {

using namespace leda::solver;

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

// The bank, `seconds` into its slide, as a model of its own.
template <class Real>
struct Stepped {
  const Seeded& seeded;
  Model<Real> model;
  StepSettings settings;
  ThreadTeam team{1};

  Stepped(double seconds, const bench::BankCase& how)
      : seeded(bench::bank_after(seconds, how)),
        model(
            make_model<Real>(seeded.particles, seeded.size, seeded.laws, how.model_settings(seeded))
                .value()),
        settings(how.step_settings(seeded)) {}

  double points() const { return static_cast<double>(model.packs.count); }
  void tidy() {
    if (is_untidy(model)) tidy_up(model);
  }
  void update_nodes() { balance_nodes(model, settings, team); }
  void update_points() { move_points(model, settings, false, team); }
};

template <class Real>
void whole_step(benchmark::State& state, const bench::BankCase& how, const std::string& target) {
  if (!bench::use_instructions(target)) return state.SkipWithError("no such instruction set");
  Stepped<Real> bank(static_cast<double>(state.range(0)), how);
  Timer(state).run(
      bank.points(),
      [&] {
        bank.tidy();
        benchmark::DoNotOptimize(step(bank.model, bank.settings, false, bank.team));
      },
      [] {});
  std::size_t packs = 0;
  for (const PackGroup& group : bank.model.packs.group) packs += group.in_use;
  state.counters["points_per_pack"] = bank.points() / static_cast<double>(packs);
}

template <class Real>
void points_alone(benchmark::State& state) {
  Stepped<Real> bank(static_cast<double>(state.range(0)), bench::bank_cases[0]);
  const auto nodes = [&] {
    bank.update_nodes();
    bank.tidy();
  };
  nodes();
  Timer(state).run(
      bank.points(), [&] { bank.update_points(); }, nodes);
}

template <class Real>
void nodes_alone(benchmark::State& state) {
  Stepped<Real> bank(0, bench::bank_cases[0]);
  Timer(state).run(
      bank.points(), [&] { bank.update_nodes(); }, [&] { bank.update_points(); });
}

template <class Real>
void packing(benchmark::State& state) {
  Stepped<Real> bank(5, bench::bank_cases[0]);
  Timer(state).run(
      bank.points(), [&] { pack(bank.seeded.particles, bank.model.grid, bank.model.packs); },
      [] {});
}

template <class Real>
void rehoming(benchmark::State& state) {
  Stepped<Real> bank(5, bench::bank_cases[0]);
  Timer(state).run(
      bank.points(), [&] { tidy_up(bank.model); },
      [&] {
        bank.update_nodes();
        bank.update_points();
      });
}

template <class Real>
void unpacking(benchmark::State& state) {
  const Stepped<Real> bank(5, bench::bank_cases[0]);
  Timer(state).run(
      bank.points(),
      [&] { benchmark::DoNotOptimize(unpack(bank.model.packs, bank.seeded.size.h)); }, [] {});
}

// The widest instruction set of this processor, and AVX2.
std::vector<std::string> instruction_sets() {
  std::vector<std::string> names{bench::name_of(hwy::SupportedAndGeneratedTargets().front())};
  if (names.front() != "avx2" && bench::use_instructions("avx2")) names.emplace_back("avx2");
  hwy::DisableTargets(0);
  return names;
}

template <class Real>
void enroll(const std::string& precision) {
  for (const std::string& target : instruction_sets()) {
    for (const bench::BankCase& how : bench::bank_cases) {
      const std::string name = "step/" + target + "/" + precision + "/" + how.name;
      benchmark::RegisterBenchmark(name.c_str(), whole_step<Real>, how, target)
          ->Arg(0)
          ->Arg(5)
          ->UseManualTime();
    }
  }
  const auto part = [&](const char* name, void (*function)(benchmark::State&)) {
    const auto measured = [function](benchmark::State& state) {
      hwy::DisableTargets(0);
      function(state);
    };
    return benchmark::RegisterBenchmark((std::string(name) + "/" + precision).c_str(), measured)
        ->UseManualTime();
  };
  part("points", points_alone<Real>)->Arg(0)->Arg(5);
  part("nodes", nodes_alone<Real>);
  part("packing", packing<Real>);
  part("rehoming", rehoming<Real>);
  part("unpacking", unpacking<Real>);
}

[[maybe_unused]] const bool enrolled = [] {
  enroll<float>("single");
  enroll<double>("double");
  return true;
}();

}  // namespace
