#pragma once
// Clays of the thesis as softening laws.

#include "solver/section/material.hpp"
#include "tests/element/table.hpp"

namespace leda::test {

/// A law of Urmi et al. from a row with alpha, beta, residual_strain and remolded_kPa.
inline Softening urmi(const Row& row, const std::string& beta = "beta") {
  UrmiSoftening law;
  law.alpha = row["alpha"];
  law.beta = row[beta];
  law.residual_strain = row["residual_strain"];
  law.remolded_strength_Pa = 1000 * row["remolded_kPa"];
  return {law};
}

/// Sainte-Monique, thesis Tables 4-1 and 5-1 (beta 2.9): s_up 40.5 kPa, G 4050 kPa.
inline constexpr double sainte_monique_peak = 40500;
inline constexpr double sainte_monique_modulus = 4.05e6;
inline Softening sainte_monique(double beta = 2.8) {
  UrmiSoftening law;
  law.alpha = 0.95;
  law.beta = beta;
  law.residual_strain = 1.8;
  law.remolded_strength_Pa = 736;
  return {law};
}

}  // namespace leda::test
