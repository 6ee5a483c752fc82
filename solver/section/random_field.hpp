#pragma once
// A strength that varies within the ground: times a lognormal random field of mean 1.

namespace leda {

/// Of the logarithm of the factor the correlation between two points is Markov's, separable:
/// exp(-2 |dx| / horizontal_m - 2 |dz| / vertical_m), both lengths being scales of fluctuation
/// (Vanmarcke 1977, 2010). Sampled in solver/materials/strength_field.hpp.
struct RandomField {
  double cov = 0;  ///< coefficient of variation of the factor, standard deviation over mean
  double horizontal_m = 0;  ///< scale of fluctuation along x
  double vertical_m = 0;    ///< scale of fluctuation along z
};

/// Standard deviation of the logarithm of the factor.
double sd_of_logarithm(const RandomField& field);

/// The factor where the standard normal field is `normal`: exp(s normal - s^2 / 2), mean 1.
double factor_at(const RandomField& field, double normal);

}  // namespace leda
