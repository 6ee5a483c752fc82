#include "solver/element_test/post_peak.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace leda::solver {

PostPeak behind_peak(const LabCurve& curve, StrainMeasure measure) {
  const auto top = std::max_element(curve.stress_Pa.begin(), curve.stress_Pa.end());
  const auto first = static_cast<std::size_t>(top - curve.stress_Pa.begin());
  PostPeak result;
  result.peak_Pa = *top;
  result.peak_strain = curve.strain[first];
  const double g = result.peak_strain > 0 ? result.peak_Pa / result.peak_strain : 0;
  result.shear_modulus_Pa = g;
  for (std::size_t i = first + 1; i < curve.strain.size(); ++i) {
    const double elastic = measure == StrainMeasure::plastic && g > 0 ? curve.stress_Pa[i] / g : 0;
    result.strain.push_back(std::max(0.0, curve.strain[i] - elastic));
    result.stress_Pa.push_back(curve.stress_Pa[i]);
  }
  return result;
}

Goodness goodness(const PostPeak& curve, const std::vector<double>& predicted_Pa) {
  const auto n = static_cast<double>(curve.stress_Pa.size());
  const double mean = std::accumulate(curve.stress_Pa.begin(), curve.stress_Pa.end(), 0.0) / n;
  double residual = 0;
  double spread = 0;
  for (std::size_t i = 0; i < curve.stress_Pa.size(); ++i) {
    residual += std::pow(curve.stress_Pa[i] - predicted_Pa[i], 2);
    spread += std::pow(curve.stress_Pa[i] - mean, 2);
  }
  return {spread > 0 ? 1 - residual / spread : 0, std::sqrt(residual / n), curve.stress_Pa.size()};
}

}  // namespace leda::solver
