#include "solver/materials/laws.hpp"

#include <algorithm>
#include <limits>

namespace leda::solver {

namespace {

// Values beyond the range of the type (an endless strain, a rate of nothing) become its ends.
template <class Real>
std::vector<Real> narrow(const std::vector<double>& column) {
  const auto smallest = static_cast<double>(std::numeric_limits<Real>::min());
  std::vector<Real> result(column.size() + Laws<Real>::padding);
  std::transform(column.begin(), column.end(), result.begin(), [smallest](double value) {
    return static_cast<Real>(value > 0 ? std::max(value, smallest) : value);
  });
  return result;
}

template <class Real>
RateRows<Real> narrow(const RateColumns& laws) {
  RateRows<Real> r;
  r.depends = laws.depends();
  r.base = narrow<Real>(laws.base);
  r.log_share = narrow<Real>(laws.log_share);
  r.power_share = narrow<Real>(laws.power_share);
  r.exponent = narrow<Real>(laws.exponent);
  r.least = narrow<Real>(laws.least);
  r.reference = narrow<Real>(laws.reference);
  return r;
}

template <class Real>
ViscousRows<Real> narrow(const ViscousLaws& laws) {
  ViscousRows<Real> v;
  if (laws.empty()) return v;
  v.rate = narrow<Real>(laws.rate);
  v.remolded_rate = narrow<Real>(laws.remolded_rate);
  v.remolded = narrow<Real>(laws.remolded);
  v.flows = std::ranges::any_of(laws.consistency, [](double eta) { return eta > 0; });
  v.consistency = narrow<Real>(laws.consistency);
  v.flow_exponent = narrow<Real>(laws.flow_exponent);
  return v;
}

}  // namespace

template <class Real>
Laws<Real> narrow_laws(const LawTable& t, bool softer) {
  Laws<Real> laws;
  laws.rows = t.rows();
  laws.bulk = narrow<Real>(t.bulk);
  laws.shear = narrow<Real>(t.shear);
  laws.peak = narrow<Real>(t.peak);
  laws.floor = narrow<Real>(t.floor);
  laws.amplitude = narrow<Real>(t.amplitude);
  laws.rate = narrow<Real>(t.rate);
  laws.exp_end = narrow<Real>(t.exp_end);
  laws.line_start = narrow<Real>(t.line_start);
  laws.line_slope = narrow<Real>(t.line_slope);
  laws.line_end = narrow<Real>(t.line_end);
  laws.last = narrow<Real>(t.last);
  laws.viscous = narrow<Real>(t.viscous);
  laws.rate_share = static_cast<Real>(t.rate_share);
  laws.tension = narrow<Real>(t.tension);
  laws.sin_friction = narrow<Real>(t.sin_friction);
  laws.pore_pressure = narrow<Real>(t.pore_pressure);
  laws.drains = std::ranges::any_of(t.sin_friction, [](double one) { return one > 0; });
  laws.cracks = std::ranges::any_of(t.tension, [](double one) { return one < beyond_reach; });
  laws.softens = std::ranges::any_of(t.softens, [](std::int32_t one) { return one != 0; });
  laws.band = t.band_m > 0;
  laws.softer = softer;
  return laws;
}

template Laws<float> narrow_laws<float>(const LawTable&, bool);
template Laws<double> narrow_laws<double>(const LawTable&, bool);

}  // namespace leda::solver
