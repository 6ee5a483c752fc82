#include "solver/materials/strength_field.hpp"

#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numbers>

#include "solver/section/key.hpp"

namespace leda::solver {
namespace {

constexpr std::size_t mode_count = 1000;

double normal_of(const Key& key) {
  return boost::math::quantile(boost::math::normal(), key.uniform());
}

double wave_number(const Key& key, double scale_of_fluctuation) {
  return 2 / scale_of_fluctuation * std::tan(std::numbers::pi * (key.uniform() - 0.5));
}

}  // namespace

StrengthField::StrengthField(const RandomField& field, std::uint64_t seed, std::string_view name,
                             const std::vector<double>& z)
    : field_(field), elevations_(z.size()) {
  const Key key = Key(seed).with("strength field").with(name);
  const double share = std::sqrt(1.0 / mode_count);
  for (std::size_t n = 0; n < mode_count; ++n) {
    const Key of_mode = key.with(n);
    modes_.push_back({wave_number(of_mode.with("kx"), field.horizontal_m),
                      wave_number(of_mode.with("kz"), field.vertical_m),
                      share * normal_of(of_mode.with("a")), share * normal_of(of_mode.with("b"))});
    for (const double elevation : z) {
      cos_z_.push_back(std::cos(modes_[n].kz * elevation));
      sin_z_.push_back(std::sin(modes_[n].kz * elevation));
    }
  }
}

std::vector<double> StrengthField::factors(double x, std::size_t count) const {
  std::vector<double> normal(count, 0.0);
  for (std::size_t n = 0; n < mode_count; ++n) {
    const Mode& mode = modes_[n];
    const double c = std::cos(mode.kx * x), s = std::sin(mode.kx * x);
    const double of_cos = mode.a * c + mode.b * s, of_sin = mode.b * c - mode.a * s;
    const double* cos_z = &cos_z_[n * elevations_];
    const double* sin_z = &sin_z_[n * elevations_];
    for (std::size_t i = 0; i < count; ++i) normal[i] += of_cos * cos_z[i] + of_sin * sin_z[i];
  }
  for (double& value : normal) value = factor_at(field_, value);
  return normal;
}

}  // namespace leda::solver
