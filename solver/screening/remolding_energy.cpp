#include "solver/screening/remolding_energy.hpp"

#include <algorithm>
#include <cmath>

#include "solver/screening/slide_energy.hpp"

namespace leda::solver {
namespace {

/// Of s_uR + (s_up - s_uR) alpha exp(-rate g) between two strains.
double exponential_part(const PostPeakCurve& c, double rate, double from, double to) {
  const double decay = (std::exp(-rate * from) - std::exp(-rate * to)) / rate;
  return c.residual_Pa * (to - from) + (c.peak_Pa - c.residual_Pa) * c.alpha * decay;
}

double linear_part(const PostPeakCurve& c) {
  return 0.5 * (c.residual_Pa + c.remolded_Pa) * (c.remolded_strain - c.residual_strain);
}

/// Strain at which the exponential branch has come down to a strength, held to the branch.
double strain_at(const PostPeakCurve& c, double strength_Pa) {
  const double share = (strength_Pa - c.residual_Pa) / ((c.peak_Pa - c.residual_Pa) * c.alpha);
  return std::clamp(-std::log(share) / c.beta, c.peak_strain, c.residual_strain);
}

}  // namespace

double residual_strength(double peak_strength_Pa) { return 0.095 * peak_strength_Pa; }

double remolded_strain(double peak_strength_Pa, double residual_strain) {
  return 0.13 * (peak_strength_Pa / 1000) * residual_strain;
}

std::optional<PostPeakCurve> post_peak_curve(const Site& site) {
  if (!site.softening || !site.remolded_strength_Pa) return std::nullopt;
  PostPeakCurve c;
  c.peak_Pa = site.peak_strength_Pa;
  c.residual_Pa = site.residual_strength_Pa.value_or(residual_strength(c.peak_Pa));
  c.remolded_Pa = *site.remolded_strength_Pa;
  c.alpha = site.softening->alpha;
  c.beta = site.softening->beta;
  c.residual_strain = site.softening->residual_strain;
  c.remolded_strain = site.remolded_strain.value_or(remolded_strain(c.peak_Pa, c.residual_strain));
  if (site.peak_strain) {
    c.peak_strain = *site.peak_strain;
  } else if (site.preconsolidation_Pa) {
    c.peak_strain = peak_strain_from(limit_state_energy(*site.preconsolidation_Pa), c.peak_Pa);
  } else {
    return std::nullopt;
  }
  return c;
}

double remolding_energy(const PostPeakCurve& c) {
  return exponential_part(c, c.beta, c.peak_strain, c.residual_strain) + linear_part(c);
}

double energy_to_remolding_index(const PostPeakCurve& c, double index) {
  const double strength = c.peak_Pa - index * (c.peak_Pa - c.remolded_Pa);
  if (strength > c.residual_Pa) {
    return exponential_part(c, c.beta, c.peak_strain, strain_at(c, strength));
  }
  const double share = (c.residual_Pa - strength) / (c.residual_Pa - c.remolded_Pa);
  const double strain = share * (c.remolded_strain - c.residual_strain);
  return exponential_part(c, c.beta, c.peak_strain, c.residual_strain) +
         0.5 * (c.residual_Pa + strength) * strain;
}

double remolding_energy_thesis_reading(const PostPeakCurve& c) {
  return exponential_part(c, -c.beta / 100, c.peak_strain, c.residual_strain) + linear_part(c);
}

double remolding_energy_leroueil(double peak_strength_Pa, double plasticity_index) {
  return 16 * peak_strength_Pa * plasticity_index;
}

double remolding_energy_linear(const PostPeakCurve& c) {
  const double slope =
      (c.peak_Pa - c.residual_Pa) * c.alpha * c.beta * std::exp(-c.beta * c.peak_strain);
  return 0.5 * (c.peak_Pa + c.remolded_Pa) * (c.peak_Pa - c.remolded_Pa) / slope;
}

}  // namespace leda::solver
