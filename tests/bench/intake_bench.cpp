// What the server does with a finished run: reads and checks its folder, stores the result.

#include <benchmark/benchmark.h>

#include "db/store.hpp"
#include "server/jobs/take_in.hpp"
#include "tests/db/samples.hpp"
#include "tests/server/run_fixture.hpp"

namespace {

using namespace leda;

void read_a_run(benchmark::State& state) {
  const db::samples::ScratchFolder folder;
  tests::write_text(folder / "case.json", tests::small_case());
  tests::leave_result(folder.path(), tests::result_of_case_in(folder.path()));
  for (auto _ : state) {
    if (!server::read_outcome(folder.path()).result) state.SkipWithError("the result is refused");
  }
}
BENCHMARK(read_a_run)->Unit(benchmark::kMicrosecond);

// start_run and take_in of the next of a job's sections, with as many in the store as the argument.
void store_a_result(benchmark::State& state) {
  const int size = static_cast<int>(state.range(0));
  const db::samples::ScratchFolder folder;
  db::Store store(folder / "leda.sqlite");
  store.add_raster(db::samples::raster());
  store.add_job(db::samples::job());
  store.set_sections("job-1", db::samples::layout(size));
  const auto sections = store.sections("job-1");
  int run = 0;
  for (auto _ : state) {
    const auto& section = sections[static_cast<std::size_t>(run)];
    const std::string id = db::samples::numbered("run-", ++run);
    store.start_run(section.id, id);
    if (!store.take_in(section.id, id, db::samples::result(), db::samples::placed(section), "{}"))
      state.SkipWithError("not taken in");
  }
}
BENCHMARK(store_a_result)->Arg(100)->Arg(1000)->Iterations(100)->Unit(benchmark::kMicrosecond);

}  // namespace
