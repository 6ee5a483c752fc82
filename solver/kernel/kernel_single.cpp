#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/kernel/kernel_single.cpp"
#include "hwy/foreach_target.h"
//
#include "solver/kernel/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {

const Kernel<float>& Single() {
  static const Kernel<float> here = kernel_here<float>();
  return here;
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace leda::solver {

HWY_EXPORT(Single);

template <>
const Kernel<float>& kernel<float>() {
  return HWY_DYNAMIC_DISPATCH(Single)();
}

}  // namespace leda::solver
#endif
