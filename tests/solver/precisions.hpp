#pragma once
// Tests of the kernel run in both number types that it runs with.

#include <gtest/gtest.h>

#include <string>

namespace leda::solver::test {

/// Both number types that the kernel runs with: what ships, and the one with 16 digits.
using BothPrecisions = ::testing::Types<float, double>;

struct PrecisionNames {
  template <class Real>
  static std::string GetName(int) {
    return sizeof(Real) == 4 ? "single" : "double";
  }
};

/// Tolerance of a test in one precision or the other.
template <class Real>
double within(double in_single, double in_double) {
  return sizeof(Real) == 4 ? in_single : in_double;
}

}  // namespace leda::solver::test
