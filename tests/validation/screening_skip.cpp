// Shows that what screening skips does not move when it is simulated, and what skipping saves.
//
//   screening_skip --first 1 --count 240 --cells 10 [--skipped-only] [--cov 0.3] >
//   screening_skip.csv
//
// One row a section; the summary goes to standard error. Exit code 1 where a skipped section moved.

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <string>

#include "solver/run/simulate.hpp"
#include "solver/screening/decide.hpp"
#include "solver/section/validate.hpp"
#include "tests/validation/generated_sections.hpp"

namespace {

using namespace leda;

struct Options {
  std::uint64_t first = 1;
  int count = 240;
  double cells_per_height = 10;
  bool skipped_only = false;
  double cov = 0;  ///< of a field of strength in all undrained ground; 0: none
};

struct Tally {
  int sections = 0, skipped = 0, skipped_moved = 0, simulated_moved = 0, simulated = 0;
  double screening_s = 0, skipped_s = 0, simulated_s = 0;
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_row(std::uint64_t seed, const test::GeneratedCase& c,
               const solver::ScreeningResult& screening, const SectionResult* result) {
  std::printf("%llu,%.2f,%.1f,%.1f,%.2f,%.2f,%d,%s,%.3f,%.3f,%.3f",
              static_cast<unsigned long long>(seed), c.height_m, c.angle_deg, c.strength_Pa / 1000,
              c.water_depth_m, c.toe_cut_m, static_cast<int>(screening.sensitive),
              to_string(screening.decision), screening.worst_intact.value_or(0),
              screening.worst_toe_cut.value_or(0), screening.worst_at_rest.value_or(0));
  if (result) {
    std::printf(",%s,%s,%.1f,%.1f,%.3f\n", to_string(result->status), result->trigger_used.c_str(),
                result->crest_to_crest_retrogression_m, result->runout_m, result->run_time_s);
  } else {
    std::printf(",,,,,\n");
  }
  std::fflush(stdout);
}

void take(Tally& tally, bool skipped, const SectionResult& result) {
  const bool moved = result.status != RunStatus::stable;
  (skipped ? tally.skipped_s : tally.simulated_s) += result.run_time_s;
  if (skipped)
    tally.skipped_moved += static_cast<int>(moved);
  else
    ++tally.simulated, tally.simulated_moved += static_cast<int>(moved);
}

/// Scales of fluctuation as clays have them (Phoon and Kulhawy 1999), one field a section.
void vary_strength(test::GeneratedCase& c, std::uint64_t seed, double cov) {
  c.settings.resolution.seed = seed;
  for (auto& [name, m] : c.section.materials) {
    if (!m.drains) m.field = RandomField{cov, 40, 2.5};
  }
}

bool run_one(std::uint64_t seed, const Options& options, Tally& tally) {
  test::GeneratedCase c = test::generate_case(seed, options.cells_per_height);
  if (options.cov > 0) vary_strength(c, seed, options.cov);
  if (const auto faults = validate(c.section, c.settings); !faults.empty()) {
    std::fprintf(stderr, "%s: %s %s\n", c.section.name.c_str(), faults[0].pointer.c_str(),
                 faults[0].message.c_str());
    return true;  // one that could not be run at all: no row
  }
  const auto start = std::chrono::steady_clock::now();
  const solver::ScreeningResult quick = solver::screen_quickly(c.section, c.settings);
  tally.screening_s += seconds_since(start);
  // Every number, also those that the decision did not need.
  const solver::ScreeningResult screening = solver::screen(c.section, c.settings);
  if (quick.decision != screening.decision) {
    std::fprintf(stderr, "%s: quick and complete screening differ\n", c.section.name.c_str());
    return false;
  }
  ++tally.sections;
  const bool skipped = screening.decision == solver::Decision::stable;
  tally.skipped += static_cast<int>(skipped);
  if (options.skipped_only && !skipped) {
    print_row(seed, c, screening, nullptr);
    return true;
  }
  const SectionResult result = solver::simulate(c.section, c.settings);
  print_row(seed, c, screening, &result);
  take(tally, skipped, result);
  return true;
}

void print_summary(const Tally& t) {
  std::fprintf(
      stderr,
      "sections %d, skipped %d, of these moved %d; simulated %d, of these moved %d\n"
      "screening %.2f s (%.2f ms each), simulating the skipped %.1f s, the others %.1f s\n",
      t.sections, t.skipped, t.skipped_moved, t.simulated, t.simulated_moved, t.screening_s,
      1000 * t.screening_s / std::max(1, t.sections), t.skipped_s, t.simulated_s);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"Simulates generated sections and compares with the decision of screening"};
  app.add_option("--first", options.first, "seed of the first section");
  app.add_option("--count", options.count, "number of sections")->check(CLI::PositiveNumber);
  app.add_option("--cells", options.cells_per_height, "cells over the height of a bank");
  app.add_flag("--skipped-only", options.skipped_only, "simulate only what screening skips");
  app.add_option("--cov", options.cov, "coefficient of variation of strength within the ground");
  CLI11_PARSE(app, argc, argv);

  std::puts(
      "seed,height_m,angle_deg,strength_kPa,water_depth_m,toe_cut_m,sensitive,decision,worst_"
      "intact,"
      "worst_toe_cut,worst_at_rest,status,trigger_used,retrogression_m,runout_m,run_time_s");
  Tally tally;
  for (int i = 0; i < options.count; ++i) {
    if (!run_one(options.first + static_cast<std::uint64_t>(i), options, tally)) return 2;
  }
  print_summary(tally);
  return tally.skipped_moved == 0 ? 0 : 1;
}
