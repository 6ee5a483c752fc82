// What a section costs beside its simulation, and the simulation itself at cells of 1 m: start of
// the program, documents, files. The store: intake_bench.cpp.

#include <benchmark/benchmark.h>
#include <spawn.h>
#include <sys/wait.h>

#include <filesystem>

#include "db/result_file.hpp"
#include "server/documents/case_file.hpp"
#include "server/documents/result_document.hpp"
#include "solver/run/simulate.hpp"
#include "tests/db/frames.hpp"
#include "tests/db/samples.hpp"
#include "tests/server/run_fixture.hpp"

extern char** environ;  // NOLINT: POSIX

namespace {

using namespace leda;

// Sainte-Monique AA' (thesis 4.5) at cells of 1 m.
server::CaseFile one_metre_case() {
  auto read =
      server::parse_case_file(tests::read_text(LEDA_TEST_DATA "/cases/sainte-monique-AA.json"));
  server::CaseFile c = std::move(read.value.value());
  c.settings.resolution.cell_m = 1;
  return c;
}

void program_start(benchmark::State& state) {
  char program[] = LEDA_PROGRAM, simulate[] = "simulate", help[] = "--help";
  char* arguments[] = {program, simulate, help, nullptr};
  posix_spawn_file_actions_t quiet;
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, 1, "/dev/null", 1, 0);
  for (auto _ : state) {
    pid_t child = 0;
    int status = 0;
    if (posix_spawn(&child, program, &quiet, nullptr, arguments, environ) != 0 ||
        waitpid(child, &status, 0) != child || status != 0) {
      state.SkipWithError("leda simulate --help failed");
      break;
    }
  }
  posix_spawn_file_actions_destroy(&quiet);
}
BENCHMARK(program_start)->Unit(benchmark::kMillisecond)->UseRealTime();

void documents_of_a_run(benchmark::State& state) {
  const std::string text = server::canonical_text(one_metre_case());
  SectionResult result = db::samples::result();
  for (int i = 0; i < 306; ++i) result.profile_after.push_back({1.0 * i, 10.0});
  for (auto _ : state) {
    const auto read = server::parse_case_file(text);
    benchmark::DoNotOptimize(server::case_sha256(*read.value));
    benchmark::DoNotOptimize(server::parse_result(server::result_text(result)));
  }
}
BENCHMARK(documents_of_a_run)->Unit(benchmark::kMillisecond);

// First and last frame of AA' at 1 m, on the disk under their name.
void fields_file(benchmark::State& state) {
  const db::samples::ScratchFolder folder;
  constexpr std::size_t particles = 19'000;
  const Frame first = db::samples::frame(0, particles), last = db::samples::frame(60, particles);
  for (auto _ : state) {
    db::ResultFileWriter file(folder / "fields.h5", {"B1", "S1", "crust"}, "", "");
    file.append(first);
    file.append(last);
    file.close();
  }
}
BENCHMARK(fields_file)->Unit(benchmark::kMillisecond)->UseRealTime();

void section_of_1_m(benchmark::State& state) {
  const server::CaseFile c = one_metre_case();
  for (auto _ : state) {
    const SectionResult result = solver::simulate(c.section, c.settings);
    state.counters["particles"] = static_cast<double>(result.particles);
    state.counters["steps"] = static_cast<double>(result.steps);
    state.counters["ns_per_particle_step"] = result.ns_per_particle_step;
  }
}
BENCHMARK(section_of_1_m)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
