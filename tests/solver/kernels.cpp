// Of the narrow kernels only those of AVX2 are wanted.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3 | HWY_AVX3_DL)

#include "tests/solver/kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/solver/kernels.cpp"
#include "hwy/foreach_target.h"
//
#include "solver/kernel/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {

const Kernel<float>& NarrowSingle() {
  static const Kernel<float> narrow = kernel_here<float, 4>();
  return narrow;
}
const Kernel<double>& NarrowDouble() {
  static const Kernel<double> narrow = kernel_here<double, 2>();
  return narrow;
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace leda::solver {

HWY_EXPORT(NarrowSingle);
HWY_EXPORT(NarrowDouble);

namespace test {

namespace {

template <class Real>
const Kernel<Real>& narrow_kernel() {
  if constexpr (sizeof(Real) == 4)
    return HWY_DYNAMIC_DISPATCH(NarrowSingle)();
  else
    return HWY_DYNAMIC_DISPATCH(NarrowDouble)();
}

template <class Real>
KernelHere<Real> named(const Kernel<Real>& kernel) {
  const std::string& instructions = kernel.instructions;
  return {&kernel, instructions + " with " + std::to_string(kernel.lanes) + " lanes",
          instructions.starts_with("avx")};
}

}  // namespace

template <class Real>
std::vector<KernelHere<Real>> kernels_here() {
  std::vector<KernelHere<Real>> all;
  const std::int64_t supported = hwy::SupportedTargets();
  std::int64_t off = 0;
  for (const std::int64_t target : {HWY_AVX3_DL, HWY_AVX3, HWY_AVX2, HWY_SSE4, HWY_SSSE3}) {
    if ((supported & target) != 0) {
      hwy::DisableTargets(off);
      const KernelHere<Real> here = named(kernel<Real>());
      if (all.empty() || all.back().kernel != here.kernel) all.push_back(here);
    }
    off |= target;
  }
  hwy::DisableTargets(0);
  if ((supported & HWY_AVX2) != 0) all.push_back(named(narrow_kernel<Real>()));
  return all;
}

template std::vector<KernelHere<float>> kernels_here();
template std::vector<KernelHere<double>> kernels_here();

}  // namespace test
}  // namespace leda::solver
#endif
