#include "solver/section/random_field.hpp"

#include <cmath>

namespace leda {

double sd_of_logarithm(const RandomField& field) {
  return std::sqrt(std::log1p(field.cov * field.cov));
}

double factor_at(const RandomField& field, double normal) {
  const double s = sd_of_logarithm(field);
  return std::exp(s * (normal - s / 2));
}

}  // namespace leda
