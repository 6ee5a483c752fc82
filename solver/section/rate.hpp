#pragma once
// How strength depends on the rate of shear, and how remolded clay flows: parameters only. SI.
// The formulas and their limits stand with each law in solver/materials/rate/.

#include <variant>

namespace leda {

/// Thesis eq. 2-5: factor 1 + mu log10(rate / reference).
struct SemiLogarithmicRate {
  double per_decade = 0;      ///< mu, 0.05 to 0.2
  double reference_rate = 0;  ///< 1/s, > 0
};

/// Thesis eq. 2-6: factor (rate / reference)^b.
struct PowerRate {
  double exponent = 0;        ///< b, 0.05 to 0.1
  double reference_rate = 0;  ///< 1/s, > 0
};

/// Zhu and Randolph, thesis eqs 2-8 and 2-9: factor 1 + eta (rate / reference)^n.
struct AdditivePowerRate {
  double viscosity = 0;       ///< eta, without unit
  double exponent = 0;        ///< n, shear thinning index, 0 < n <= 1
  double reference_rate = 0;  ///< 1/s, > 0
};

using RateLaw = std::variant<SemiLogarithmicRate, PowerRate, AdditivePowerRate>;

/// Thesis eqs 2-18, 2-19: stress = yield stress + eta rate.
struct BinghamFlow {
  double viscosity_Pa_s = 0;  ///< eta
};

/// Thesis eq. 2-7: stress = yield stress + eta rate^n.
struct HerschelBulkleyFlow {
  double consistency_Pa_sn = 0;  ///< eta, Pa s^n
  double exponent = 1;           ///< n, > 0; below 1 thins under shear
};

using FlowLaw = std::variant<BinghamFlow, HerschelBulkleyFlow>;

}  // namespace leda
