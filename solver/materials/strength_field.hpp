#pragma once
// A random field of strength, sampled: its factor at points of the ground.
//
// Randomization method (Kraichnan 1970; Hesse, Prykhodko, Schlueter and Attinger 2014; the
// generator of GSTools). With a and b standard normal, k drawn from the spectrum of the
// correlation:
//
//   Z(x, z) = sqrt(1/N) sum_n a_n cos(kx_n x + kz_n z) + b_n sin(kx_n x + kz_n z)
//
// exp(-2 |d| / theta) is the characteristic function of Cauchy's distribution of scale 2 / theta,
// and Markov's separable correlation that of two independent ones: k = 2 / theta tan(pi (u - 1/2)).
// Whatever N, Z is standard normal at every point and has exactly that correlation over all seeds;
// N = 1000 (GSTools) brings several points together near to jointly normal.

#include <cstdint>
#include <string_view>
#include <vector>

#include "solver/section/random_field.hpp"

namespace leda::solver {

/// The field at points of given elevations. It is a function of the seed, the name and the place
/// alone: the same under any cells, in any order, beside any other material.
class StrengthField {
 public:
  /// @param name of the material: each has a field of its own
  /// @param z elevations, m
  StrengthField(const RandomField& field, std::uint64_t seed, std::string_view name,
                const std::vector<double>& z);

  /// Factors on the strength at the first `count` elevations, on the vertical through x.
  std::vector<double> factors(double x, std::size_t count) const;

 private:
  struct Mode {
    double kx, kz;  ///< 1/m
    double a, b;    ///< of cos and sin, over sqrt(N)
  };

  RandomField field_;
  std::size_t elevations_;
  std::vector<Mode> modes_;
  std::vector<double> cos_z_, sin_z_;  ///< [mode][elevation], of kz z
};

}  // namespace leda::solver
