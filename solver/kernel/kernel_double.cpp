#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "solver/kernel/kernel_double.cpp"
#include "hwy/foreach_target.h"
//
#include "solver/kernel/kernel-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {

const Kernel<double>& Double() {
  static const Kernel<double> here = kernel_here<double>();
  return here;
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace leda::solver {

HWY_EXPORT(Double);

template <>
const Kernel<double>& kernel<double>() {
  return HWY_DYNAMIC_DISPATCH(Double)();
}

}  // namespace leda::solver
#endif
