// What the machine itself can do, one core: bandwidth of a triad a[i] = b[i] + s c[i] (McCalpin's
// STREAM) in the caches and in memory, and multiply-adds in single precision.

#include <benchmark/benchmark.h>

#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/machine_bench.cpp"
#include "hwy/foreach_target.h"
//
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace leda::bench {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void Triad(float* a, const float* b, const float* c, std::size_t count) {
  const hn::ScalableTag<float> d;
  const auto scale = hn::Set(d, 0.5F);
  for (std::size_t i = 0; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) {
    hn::StoreU(hn::MulAdd(scale, hn::LoadU(d, c + i), hn::LoadU(d, b + i)), d, a + i);
  }
}

// `rounds` of 12 independent multiply-adds; returns the floating-point operations done.
template <class D>
HWY_INLINE double multiply_add(D d, std::size_t rounds, float* out) {
  auto s0 = hn::Set(d, *out), s1 = s0, s2 = s0, s3 = s0, s4 = s0, s5 = s0, s6 = s0, s7 = s0;
  auto s8 = s0, s9 = s0, s10 = s0, s11 = s0;
  const auto a = hn::Set(d, 0.999F), b = hn::Set(d, 0.001F);
  for (std::size_t i = 0; i < rounds; ++i) {
    for (auto* s : {&s0, &s1, &s2, &s3, &s4, &s5, &s6, &s7, &s8, &s9, &s10, &s11}) {
      *s = hn::MulAdd(*s, a, b);
    }
  }
  auto sum = s0;
  for (auto* s : {&s1, &s2, &s3, &s4, &s5, &s6, &s7, &s8, &s9, &s10, &s11}) sum = hn::Add(sum, *s);
  *out = hn::GetLane(sum);
  return 2.0 * 12 * static_cast<double>(hn::Lanes(d) * rounds);
}

double MultiplyAddOfEight(std::size_t rounds, float* out) {
  return multiply_add(hn::CappedTag<float, 8>(), rounds, out);
}

double MultiplyAddOfAll(std::size_t rounds, float* out) {
  return multiply_add(hn::ScalableTag<float>(), rounds, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace leda::bench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace leda::bench {

HWY_EXPORT(Triad);
HWY_EXPORT(MultiplyAddOfEight);
HWY_EXPORT(MultiplyAddOfAll);

namespace {

void bandwidth(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0)) * 1024 / 3 / sizeof(float);
  std::vector<float> a(count, 0), b(count, 1), c(count, 2);
  for (auto _ : state) {
    HWY_DYNAMIC_DISPATCH(Triad)(a.data(), b.data(), c.data(), count);
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() *
                          static_cast<std::int64_t>(3 * count * sizeof(float)));
}
// KiB of the three arrays together: within a level-2 cache, a level-3 cache, beyond both.
BENCHMARK(bandwidth)->Arg(512)->Arg(6 * 1024)->Arg(384 * 1024);

template <class Run>
void flops(benchmark::State& state, const Run& run) {
  float out = 1;
  double done = 0;
  for (auto _ : state) done += run(10'000, &out);
  benchmark::DoNotOptimize(out);
  state.counters["flops"] = benchmark::Counter(done, benchmark::Counter::kIsRate);
}

void multiply_adds_of_8_lanes(benchmark::State& state) {
  flops(state, [](std::size_t rounds, float* out) {
    return HWY_DYNAMIC_DISPATCH(MultiplyAddOfEight)(rounds, out);
  });
}
BENCHMARK(multiply_adds_of_8_lanes);

void multiply_adds_of_all_lanes(benchmark::State& state) {
  flops(state, [](std::size_t rounds, float* out) {
    return HWY_DYNAMIC_DISPATCH(MultiplyAddOfAll)(rounds, out);
  });
}
BENCHMARK(multiply_adds_of_all_lanes);

}  // namespace
}  // namespace leda::bench
#endif
