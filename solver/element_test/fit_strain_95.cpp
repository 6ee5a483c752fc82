#include "solver/element_test/fit_strain_95.hpp"

#include <cmath>

#include "solver/materials/softening/einav_randolph.hpp"

namespace leda::solver {
namespace {

struct Spot {
  double strain;
  double stress_Pa;
};

/// The first crossing of a stress, or the last point.
Spot spot_at(const PostPeak& curve, double stress_Pa) {
  double strain_before = 0;
  double stress_before = curve.peak_Pa;
  for (std::size_t i = 0; i < curve.strain.size(); ++i) {
    if (curve.stress_Pa[i] <= stress_Pa) {
      const double t = (stress_before - stress_Pa) / (stress_before - curve.stress_Pa[i]);
      return {std::lerp(strain_before, curve.strain[i], t), stress_Pa};
    }
    strain_before = curve.strain[i];
    stress_before = curve.stress_Pa[i];
  }
  return {strain_before, stress_before};
}

}  // namespace

double strain_95(double strain, double strength_ratio, double sensitivity) {
  const double remolded = 1 / sensitivity;
  return -3 * strain / std::log((strength_ratio - remolded) / (1 - remolded));
}

Strain95Fit fit_strain_95(const PostPeak& curve, double remolded_Pa) {
  Strain95Fit fit;
  if (curve.stress_Pa.empty()) fit.faults.emplace_back("no point behind the peak");
  if (!(remolded_Pa > 0) || remolded_Pa >= curve.peak_Pa) {
    fit.faults.emplace_back("the remolded strength must be above 0 and below the peak");
  }
  if (!fit.faults.empty()) return fit;
  const Spot spot = spot_at(curve, (curve.peak_Pa + remolded_Pa) / 2);
  fit.sensitivity = curve.peak_Pa / remolded_Pa;
  fit.strain_used = spot.strain;
  fit.reduction_used = (curve.peak_Pa - spot.stress_Pa) / (curve.peak_Pa - remolded_Pa);
  const double found = strain_95(spot.strain, spot.stress_Pa / curve.peak_Pa, fit.sensitivity);
  if (!(found > 0) || !std::isfinite(found)) {
    fit.faults.emplace_back("the stress does not fall behind the peak");
    return fit;
  }
  fit.law = {remolded_Pa, found};
  fit.remolded_strain = 3 * found;
  if (fit.reduction_used < 0.4999) {
    fit.warnings.push_back("the curve ends at " +
                           std::to_string(std::lround(100 * fit.reduction_used)) +
                           " % of the loss: strain_95 is from its last point, not from 50 %");
  }
  const SofteningCurve law = curve_of(fit.law, curve.peak_Pa);
  std::vector<double> predicted;
  for (const double strain : curve.strain) predicted.push_back(strength(law, strain));
  fit.goodness = goodness(curve, predicted);
  return fit;
}

}  // namespace leda::solver
