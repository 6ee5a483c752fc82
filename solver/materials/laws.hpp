#pragma once
// The law table as the kernel reads it, in the kernel's number type.

#include <cstddef>
#include <vector>

#include "solver/materials/law_table.hpp"

namespace leda::solver {

/// Rate law of each row (see RateColumns).
template <class Real>
struct RateRows {
  bool depends = false;  ///< a row has one
  std::vector<Real> base, log_share, power_share, exponent, least, reference;
};

/// Rate and flow of each row (see ViscousLaws). The flags say which parts a run needs at all.
template <class Real>
struct ViscousRows {
  bool flows = false;  ///< a row has a flow law
  RateRows<Real> rate, remolded_rate;
  std::vector<Real> remolded, consistency, flow_exponent;
};

/// One entry a row. Columns go on with `padding` entries beyond the last row, so that two vectors
/// can be read from any row on.
template <class Real>
struct Laws {
  static constexpr std::size_t padding = 32;

  std::size_t rows = 0;  ///< without the padding
  std::vector<Real> bulk, shear, peak;
  std::vector<Real> floor, amplitude, rate, exp_end, line_start, line_slope, line_end, last;
  ViscousRows<Real> viscous;
  std::vector<Real> tension, sin_friction, pore_pressure;
  Real rate_share = 1;   ///< as in LawTable
  bool cracks = false;   ///< a row has a tensile strength
  bool drains = false;   ///< a row has a friction angle
  bool softens = false;  ///< a row has a softening law
  bool band = false;     ///< softening goes by the strain averaged over a band
  /// Whether thin and strained ground, which would limit the time step of the whole model, gets
  /// lower moduli (solver/kernel/softer-inl.hpp).
  bool softer = false;
};

template <class Real>
Laws<Real> narrow_laws(const LawTable& table, bool softer);

}  // namespace leda::solver
