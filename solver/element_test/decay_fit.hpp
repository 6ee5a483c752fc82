#pragma once
// Least squares of an exponential loss: s = floor + (peak - floor) alpha exp(-beta x), capped at
// the peak.

#include <optional>
#include <vector>

namespace leda::solver {

struct Decay {
  double alpha = 1;
  double beta = 0;
  double floor = 0;
};

struct DecayFit {
  Decay decay;
  double alpha_error = 0;  ///< standard error; zero where there are no spare points
  double beta_error = 0;
};

/// Stress of the decay at a strain.
double stress(const Decay& decay, double peak, double x);

/// Straight line through ln((s - floor)/(peak - floor)): the trend line of a spreadsheet.
/// @return nothing for fewer than two usable points, or where the line does not fall
std::optional<Decay> trend_line(const std::vector<double>& x, const std::vector<double>& s,
                                double peak, double floor);

/// Levenberg-Marquardt on the stress itself, from a start. The floor moves only if asked to, and
/// stays between zero and the peak.
/// @return nothing where it does not converge to a falling curve
std::optional<DecayFit> least_squares(const std::vector<double>& x, const std::vector<double>& s,
                                      double peak, const Decay& start, bool fit_floor);

}  // namespace leda::solver
