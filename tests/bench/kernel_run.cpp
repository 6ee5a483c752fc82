// A short run that is always the same, for count_instructions.sh: steps on a bank that gives way at
// once.
//   kernel_run single|double plain|rate|averaged|long avx2|sse4
// Prints how often each part was called for how many points, as lines "name,count". Ends with 77
// where this processor does not have the instruction set.

#include <hwy/nanobenchmark.h>

#include <cstddef>
#include <cstdio>
#include <string_view>

#include "tests/bench/bank_case.hpp"
#include "tests/bench/instruction_set.hpp"
#include "tests/solver/bank.hpp"

// As it is loaded libhwy asks how fine its timer is, with an instruction that valgrind does not
// know on every processor. Nothing here asks for the time, so that this takes the place of its
// answer.
uint64_t hwy::platform::TimerResolution() { return 1; }

namespace {

using namespace leda::solver;

constexpr int steps = 200;  // 0.8 s: elastic waves, yield and points that leave their cells
constexpr int rehomings = 20;

template <class Real>
bool run(const Seeded& seeded, const bench::BankCase& how) {
  auto model =
      make_model<Real>(seeded.particles, seeded.size, seeded.laws, how.model_settings(seeded));
  if (!model) return false;
  const StepSettings settings = how.step_settings(seeded);
  ThreadTeam team(1);
  for (int i = 0; i < steps; ++i) {
    // At fixed steps, so that the number of calls does not hang on the rule for when.
    if (i % (steps / rehomings) == 0 && !tidy_up(*model)) return false;
    if (step(*model, settings, false, team).points.left_grid) return false;
  }
  return true;
}

}  // namespace

int main(int count, char** words) {
  const std::string_view precision = count == 4 ? words[1] : "", name = count == 4 ? words[2] : "";
  const bench::BankCase* how = nullptr;
  for (const bench::BankCase& one : bench::bank_cases) {
    if (name == one.name) how = &one;
  }
  if (how == nullptr || (precision != "single" && precision != "double")) {
    std::fprintf(stderr, "kernel_run single|double plain|rate|averaged|long avx2|sse4\n");
    return 2;
  }
  if (!bench::use_instructions(words[3])) {
    std::fprintf(stderr, "kernel_run: this processor has no %s\n", words[3]);
    return 77;
  }
  const Seeded seeded =
      seed_particles(how->of(test::bank(12, 40, 15e3)), test::coarse().resolution);
  const bool ran = precision == "single" ? run<float>(seeded, *how) : run<double>(seeded, *how);
  if (!ran) {
    std::fprintf(stderr, "kernel_run: a point left the grid\n");
    return 1;
  }
  std::printf("points,%zu\nsteps,%d\nrehomings,%d\n", seeded.particles.size(), steps, rehomings);
  return 0;
}
