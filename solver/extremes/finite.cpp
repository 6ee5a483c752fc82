#include "solver/extremes/finite.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

bool is_finite(const Frame& f) {
  const auto all = [](const std::vector<float>& values) {
    return std::ranges::all_of(values, [](float v) { return std::isfinite(v); });
  };
  return std::isfinite(f.time_s) && all(f.x) && all(f.z) && all(f.velocity_x) &&
         all(f.velocity_z) && all(f.stress_xx) && all(f.stress_zz) && all(f.stress_xz) &&
         all(f.stress_yy) && all(f.plastic_strain) && all(f.strength) && all(f.volume);
}

bool is_finite(const SectionResult& r) {
  const auto number = [](double v) { return std::isfinite(v); };
  const auto point = [](Point p) { return std::isfinite(p.x) && std::isfinite(p.z); };
  return number(r.crest_to_crest_retrogression_m) && number(r.runout_m) &&
         number(r.runout_from_crest_m) && point(r.crest) && point(r.toe) && point(r.backscarp) &&
         point(r.front) && number(r.simulated_s) && number(r.run_time_s) &&
         number(r.ns_per_particle_step) && number(r.balances.mass) && number(r.balances.momentum) &&
         number(r.balances.energy) && number(r.numerical_dissipation) &&
         std::ranges::all_of(r.profile_after, point);
}

}  // namespace leda::solver
