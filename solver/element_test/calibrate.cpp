#include "solver/element_test/calibrate.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

#include "solver/element_test/dissipation.hpp"
#include "solver/materials/softening.hpp"

namespace leda::solver {
namespace {

double total(const SofteningCurve& c) { return has_end(c) ? dissipation(c, c.line_end) : 0; }

/// The law in a cell of `scale` times the specimen. The one rule of scaling is softening_curve().
SofteningCurve scaled(const Softening& softening, double peak_Pa, double scale) {
  return softening_curve(softening, peak_Pa, scale * softening.reference_size_m);
}

/// Energy per area that a regularization keeps: what lies above s_uR for `beta`; for `whole-curve`
/// all of it to gamma_r, or what lies above the last strength where there is no gamma_r.
double kept_energy(const SofteningCurve& c, Regularization regularization) {
  if (regularization == Regularization::whole_curve && has_end(c)) {
    return dissipation_by_quadrature(c, c.line_end);
  }
  return excess_by_quadrature(c);
}

/// Scale of the law at which cell times energy(law) is the specimen's energy.
template <class Energy>
std::optional<double> equal_energy_scale(const Softening& softening, double peak_Pa, double cell_m,
                                         const Energy& energy) {
  const double wanted = softening.reference_size_m * energy(scaled(softening, peak_Pa, 1));
  const auto off = [&](double log_scale) {
    return std::log(cell_m * energy(scaled(softening, peak_Pa, std::exp(log_scale))) / wanted);
  };
  // Any two sizes a user may name lie within a factor of 1e6 of each other.
  double low = std::log(1e-6);
  double high = std::log(1e6);
  const double off_low = off(low);
  const double off_high = off(high);
  if (!(off_low * off_high < 0)) return {};
  std::uintmax_t steps = 200;
  const auto bracket = boost::math::tools::toms748_solve(
      off, low, high, off_low, off_high, boost::math::tools::eps_tolerance<double>(48), steps);
  return std::exp((bracket.first + bracket.second) / 2);
}

}  // namespace

Calibration calibrate(const Softening& softening, double peak_Pa, double shear_modulus_Pa,
                      double cell_m) {
  Calibration result;
  result.regularization = softening.regularization;
  result.cell_m = cell_m;
  result.reference_size_m = softening.reference_size_m;
  result.reference = scaled(softening, peak_Pa, 1);
  result.cell = softening_curve(softening, peak_Pa, cell_m);
  if (softening.regularization != Regularization::none) {
    result.scale_closed_form = cell_m / softening.reference_size_m;
    result.scale_numerical = equal_energy_scale(
        softening, peak_Pa, cell_m,
        [&](const SofteningCurve& c) { return kept_energy(c, softening.regularization); });
  }
  if (softening.regularization == Regularization::beta) {
    result.scale_to_residual_strain =
        equal_energy_scale(softening, peak_Pa, cell_m, excess_to_residual_strain);
  }
  result.reference_excess = softening.reference_size_m * excess(result.reference);
  result.cell_excess = cell_m * excess(result.cell);
  result.reference_total = softening.reference_size_m * total(result.reference);
  result.cell_total = cell_m * total(result.cell);
  result.steepest_loss_Pa = steepest_loss(result.cell);
  result.snaps_back = result.steepest_loss_Pa > shear_modulus_Pa;
  return result;
}

}  // namespace leda::solver
