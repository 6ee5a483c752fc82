// The kernel of one number type and one instruction set as a table of functions.

#if defined(LEDA_SOLVER_KERNEL_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef LEDA_SOLVER_KERNEL_INL
#undef LEDA_SOLVER_KERNEL_INL
#else
#define LEDA_SOLVER_KERNEL_INL
#endif

#include "hwy/highway.h"
#include "solver/kernel/band-inl.hpp"
#include "solver/kernel/step-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace leda::solver::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// With vectors of at most `most_lanes`: all of a pack, or fewer, to test that the width changes
/// nothing.
template <class Real, std::size_t most_lanes = Pack<Real>::lanes>
Kernel<Real> kernel_here() {
  using Tag = hn::CappedTag<Real, most_lanes>;
  using Rows = hn::CappedTag<Real, std::min(most_lanes, rows_at_once)>;
  Kernel<Real> k;
  for (const char* c = hwy::TargetName(HWY_TARGET); *c != 0; ++c) {
    k.instructions += static_cast<char>(*c >= 'A' && *c <= 'Z' ? *c - 'A' + 'a' : *c);
  }
  k.lanes = hn::Lanes(Tag());
  k.update_columns = [](Grid<Real>& grid, const StepSettings& step, std::size_t first,
                        std::size_t last) {
    return update_columns(Rows(), grid, step, first, last);
  };
  k.spread = [](Packs<Real>& packs, Grid<Real>& grid, std::size_t first, std::size_t last) {
    return spread_packs(Tag(), packs, grid, first, last);
  };
  k.step = [](Packs<Real>& packs, Grid<Real>& grid, const Laws<Real>& laws,
              const StepSettings& step, bool keep, std::size_t first, std::size_t last) {
    return step_packs(Tag(), packs, grid, laws, step, keep, first, last);
  };
  k.add_dilation = [](const Packs<Real>& packs, Grid<Real>& grid, std::size_t first,
                      std::size_t last) { add_dilation(Tag(), packs, grid, first, last); };
  k.steepest = [](const Packs<Real>& packs, Grid<Real>& grid, std::size_t first, std::size_t last) {
    return steepest(Tag(), packs, grid, first, last);
  };
  k.add_up_band = [](Grid<Real>& grid, std::size_t first, std::size_t last) {
    add_up_band(Rows(), grid, first, last);
  };
  k.smooth_band = [](Grid<Real>& grid, std::size_t pass, std::size_t first, std::size_t last) {
    smooth_band(Rows(), grid, pass, first, last);
  };
  k.add_stress = [](const Packs<Real>& packs, Grid<Real>& grid, std::size_t first,
                    std::size_t last) { add_stress(Tag(), packs, grid, first, last); };
  return k;
}

}  // namespace leda::solver::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
