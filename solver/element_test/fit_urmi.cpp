#include "solver/element_test/fit_urmi.hpp"

#include <algorithm>
#include <cmath>

#include "solver/element_test/decay_fit.hpp"
#include "solver/materials/softening/urmi.hpp"

namespace leda::solver {
namespace {

constexpr std::size_t least_points = 4;

std::string kPa(double Pa) {
  std::string text = std::to_string(Pa / 1000);
  text.erase(text.find('.') + 4);
  return text + " kPa";
}

struct Points {
  std::vector<double> x, s;
};

Points above(const PostPeak& curve, double stress_Pa) {
  Points points;
  for (std::size_t i = 0; i < curve.strain.size(); ++i) {
    if (curve.stress_Pa[i] <= stress_Pa) continue;
    points.x.push_back(curve.strain[i]);
    points.s.push_back(curve.stress_Pa[i]);
  }
  return points;
}

std::vector<std::string> faults_of(const UrmiFitInput& input, double residual_Pa) {
  std::vector<std::string> faults;
  const double peak = input.curve.peak_Pa;
  if (input.curve.stress_Pa.size() < least_points) {
    faults.push_back("only " + std::to_string(input.curve.stress_Pa.size()) +
                     " points behind the peak: at least 4 are needed");
  }
  if (!(input.remolded_Pa > 0) || input.remolded_Pa >= peak) {
    faults.push_back("remolded strength is " + kPa(input.remolded_Pa) +
                     ": must be above 0 and below the peak of " + kPa(peak));
  }
  if (residual_Pa < input.remolded_Pa || residual_Pa >= peak) {
    faults.push_back("residual strength is " + kPa(residual_Pa) +
                     ": must lie between the remolded strength of " + kPa(input.remolded_Pa) +
                     " and the peak of " + kPa(peak));
  }
  return faults;
}

/// Step 1. With s_uR unknown, the points that lie above it depend on it: repeat until they agree.
std::optional<DecayFit> fit_decay(const UrmiFitInput& input, double residual_Pa, UrmiFit& fit) {
  const double peak = input.curve.peak_Pa;
  std::optional<DecayFit> result;
  double floor = residual_Pa;
  for (int round = 0; round < 20; ++round) {
    const Points points = above(input.curve, floor);
    const auto start = trend_line(points.x, points.s, peak, floor);
    if (!start) return {};
    if (round == 0) {
      fit.alpha_trend_line = start->alpha;
      fit.beta_trend_line = start->beta;
    }
    result = least_squares(points.x, points.s, peak, *start, input.fit_residual);
    if (!result) return {};
    fit.points_fitted = points.x.size();
    const double moved = std::abs(result->decay.floor - floor);
    floor = std::clamp(result->decay.floor, input.remolded_Pa, 0.99 * peak);
    if (!input.fit_residual || moved < 1e-9 * peak) break;
  }
  result->decay.floor = floor;
  return result;
}

/// Step 2: the strain where the test crosses s_uR, between its two points.
std::optional<double> crossing(const PostPeak& curve, double stress_Pa) {
  for (std::size_t i = 1; i < curve.strain.size(); ++i) {
    const double before = curve.stress_Pa[i - 1];
    const double after = curve.stress_Pa[i];
    if (before > stress_Pa && after <= stress_Pa) {
      return std::lerp(curve.strain[i - 1], curve.strain[i],
                       (before - stress_Pa) / (before - after));
    }
  }
  return {};
}

/// Step 3: eq. 3-12 over all points behind gamma_R, as the slope of a line through (gamma_R, s_uR).
std::optional<double> remolded_strain_of(const PostPeak& curve, double residual_strain,
                                         double residual_Pa, double remolded_Pa) {
  double numerator = 0;
  double denominator = 0;
  for (std::size_t i = 0; i < curve.strain.size(); ++i) {
    const double further = curve.strain[i] - residual_strain;
    const double lost = residual_Pa - curve.stress_Pa[i];
    // Points at s_ur lie on the flat end, not on the line.
    if (further <= 0 || lost <= 0 || curve.stress_Pa[i] <= 1.001 * remolded_Pa) continue;
    numerator += further * lost;
    denominator += further * further;
  }
  if (numerator <= 0) return {};
  return residual_strain + (residual_Pa - remolded_Pa) * denominator / numerator;
}

void complete(const UrmiFitInput& input, const DecayFit& decay, UrmiFit& fit) {
  UrmiSoftening& law = fit.law;
  const double peak = input.curve.peak_Pa;
  const double residual = decay.decay.floor;
  law.alpha = decay.decay.alpha;
  law.beta = decay.decay.beta;
  law.residual_strength_Pa = residual;
  law.remolded_strength_Pa = input.remolded_Pa;
  const auto crossed = crossing(input.curve, residual);
  fit.residual_strain_from_test = crossed.has_value();
  law.residual_strain =
      crossed.value_or(std::max(0.0, std::log(law.alpha / input.residual_share) / law.beta));
  const auto line = crossed ? remolded_strain_of(input.curve, *crossed, residual, input.remolded_Pa)
                            : std::nullopt;
  fit.remolded_strain_from_test = line.has_value();
  law.remolded_strain = line.value_or(remolded_strain(law, peak));
}

void warn(const UrmiFitInput& input, UrmiFit& fit) {
  auto& warnings = fit.warnings;
  if (fit.reduction < least_reduction) {
    warnings.push_back("the curve ends at " + std::to_string(std::lround(100 * fit.reduction)) +
                       " % of the loss from peak to remolded strength: below 30 % beta is a guess");
  }
  if (!fit.residual_strain_from_test) {
    warnings.push_back(
        "residual_strain is beyond the curve: read where the exponential comes "
        "within " +
        std::to_string(100 * input.residual_share).substr(0, 4) + " % of s_uR");
  }
  if (!fit.remolded_strain_from_test) {
    warnings.emplace_back("remolded_strain is beyond the curve: from the correlation of eq. 3-13");
  }
  if (fit.law.alpha < 0.6 || fit.law.alpha > 1.6) {
    warnings.push_back("alpha is " + std::to_string(fit.law.alpha).substr(0, 5) +
                       ", outside the 0.64 to 1.53 of the thesis's sites");
  }
}

}  // namespace

UrmiFit fit_urmi(const UrmiFitInput& input) {
  UrmiFit fit;
  const double peak = input.curve.peak_Pa;
  const double residual =
      input.residual_Pa.value_or(std::max(0.095 * peak, std::min(input.remolded_Pa, 0.99 * peak)));
  fit.faults = faults_of(input, residual);
  if (!fit.faults.empty()) return fit;
  const auto decay = fit_decay(input, residual, fit);
  if (!decay) {
    fit.faults.emplace_back("the stress behind the peak does not fall like an exponential");
    return fit;
  }
  fit.alpha_error = decay->alpha_error;
  fit.beta_error = decay->beta_error;
  complete(input, *decay, fit);
  fit.reduction = input.curve.reduction(input.remolded_Pa);
  const SofteningCurve law = curve_of(fit.law, peak);
  std::vector<double> predicted;
  for (const double strain : input.curve.strain) predicted.push_back(strength(law, strain));
  fit.goodness = goodness(input.curve, predicted);
  warn(input, fit);
  return fit;
}

}  // namespace leda::solver
