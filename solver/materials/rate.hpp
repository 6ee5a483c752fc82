#pragma once
// Every rate and flow law in one place. All are scalar functions of the engineering shear rate.

#include <variant>

#include "solver/materials/rate/additive_power.hpp"
#include "solver/materials/rate/bingham.hpp"
#include "solver/materials/rate/herschel_bulkley.hpp"
#include "solver/materials/rate/power.hpp"
#include "solver/materials/rate/semi_logarithmic.hpp"

namespace leda::solver {

/// What the strength at the reference rate is multiplied with, >= 1.
inline double strength_factor(const RateLaw& law, double rate) {
  return std::visit([&](const auto& one) { return strength_factor(one, rate); }, law);
}

/// Shear stress of flowing clay, Pa.
inline double flow_stress(const FlowLaw& law, double yield_Pa, double rate) {
  return std::visit([&](const auto& one) { return flow_stress(one, yield_Pa, rate); }, law);
}

/// Shear rate of clay under a stress, 1/s; zero up to the yield stress.
inline double flow_rate(const FlowLaw& law, double yield_Pa, double stress_Pa) {
  return std::visit([&](const auto& one) { return flow_rate(one, yield_Pa, stress_Pa); }, law);
}

}  // namespace leda::solver
