#pragma once
// The part of a laboratory curve behind its peak, and how well a law follows it.

#include <vector>

#include "solver/element_test/lab_curve.hpp"

namespace leda::solver {

/// The strain a law is fitted over.
enum class StrainMeasure {
  plastic,  ///< gamma - tau/G, zero at the peak: what the solver's laws count
  total     ///< as the test shows it: what the thesis plots (3.4.3)
};

/// Points behind the peak, in order; strains as the measure says.
struct PostPeak {
  double peak_Pa = 0;           ///< s_up
  double peak_strain = 0;       ///< gamma_p, total
  double shear_modulus_Pa = 0;  ///< s_up / gamma_p (thesis 4.4)
  std::vector<double> strain;
  std::vector<double> stress_Pa;

  /// Share of the loss from s_up to s_ur that the last point has reached.
  double reduction(double remolded_Pa) const {
    return (peak_Pa - stress_Pa.back()) / (peak_Pa - remolded_Pa);
  }
};

/// @param curve at least one point; the first largest stress is the peak. A curve whose first point
/// is its peak has no elastic part: its strains count as plastic already.
PostPeak behind_peak(const LabCurve& curve, StrainMeasure measure);

struct Goodness {
  double r2 = 0;       ///< 1 - (residual / total) sum of squares, of stress
  double rmse_Pa = 0;  ///< root mean square of the residuals
  std::size_t points = 0;
};

/// @param predicted_Pa as many as there are points
Goodness goodness(const PostPeak& curve, const std::vector<double>& predicted_Pa);

}  // namespace leda::solver
