// The way over the map: a profile cut from a DEM, and zones of a river's placed results.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "profiles/trace_profile.hpp"
#include "profiles/zonation.hpp"
#include "tests/profiles/drawn_dem.hpp"

namespace {

using namespace leda;

// A plateau of 20 m in the north of a plain at 8 m, 1 m cells.
double bank(MapPoint p) { return 8 + 12 * std::clamp((p.y - 250) / 20, 0.0, 1.0); }

void profile_cut(benchmark::State& state) {
  const test::TestFolder folder;
  const auto file =
      test::write_geotiff(test::computed(1000, 500, {0, 1, 0, 500, 0, -1}, bank), folder / "d.tif");
  const auto dem = profiles::Dem::open(file);
  double x = 10;
  for (auto _ : state) {
    profiles::LaidSection section;
    section.name = "S";
    section.trace = {{x, 450}, {x, 150}};
    const auto cut = profiles::trace_profile(section, dem);
    if (!std::holds_alternative<Profile>(cut)) state.SkipWithError("no profile");
    x = x > 980 ? 10 : x + 7;
  }
}
BENCHMARK(profile_cut)->Unit(benchmark::kMicrosecond);

// Sections 20 m apart along x that slid by 20 to 100 m; every seventh is stable.
std::vector<PlacedResult> river(std::int64_t count) {
  std::vector<PlacedResult> all;
  for (std::int64_t i = 0; i < count; ++i) {
    const double x = 20 * static_cast<double>(i);
    PlacedResult p;
    p.section = "S" + std::to_string(i);
    p.line = 0;
    p.order = x;
    p.known = true;
    p.moved = i % 7 != 0;
    p.retrogression_m = p.moved ? 60 + 40 * std::sin(x / 130) : 0;
    p.runout_m = p.retrogression_m / 3;
    p.crest = {x, 40};
    p.toe = {x, 0};
    p.backscarp = p.moved ? MapPoint{x, 40 + p.retrogression_m} : p.toe;
    p.front = {x, -p.runout_m};
    all.push_back(p);
  }
  return all;
}

void zonation(benchmark::State& state) {
  const auto results = river(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(profiles::make_zones(results));
}
BENCHMARK(zonation)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

}  // namespace
