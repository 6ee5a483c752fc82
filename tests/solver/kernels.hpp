#pragma once
// Every kernel that this processor can run: each instruction set, and vectors shorter than its own.

#include <string>
#include <vector>

#include "solver/kernel/kernel.hpp"

namespace leda::solver::test {

template <class Real>
struct KernelHere {
  const Kernel<Real>* kernel;
  std::string name;  ///< instructions and lanes
  bool fuses;  ///< products and sums in one rounding, as all that ships on AVX2 and later does
};

/// From the widest down: the targets of Highway one after the other, and AVX2 with vectors of 8 and
/// 4 lanes (4 and 2 in double). Empty is no choice: there is always the scalar one.
template <class Real>
std::vector<KernelHere<Real>> kernels_here();

}  // namespace leda::solver::test
