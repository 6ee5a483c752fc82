#include "solver/materials/softening.hpp"

#include <variant>

#include "solver/materials/softening/dey.hpp"
#include "solver/materials/softening/einav_randolph.hpp"
#include "solver/materials/softening/exponential.hpp"
#include "solver/materials/softening/linear.hpp"
#include "solver/materials/softening/urmi.hpp"

namespace leda::solver {
namespace {

/// Every strain of the curve divided by the scale: area under the curve times the cell is that of
/// the specimen, exactly.
SofteningCurve scale_whole_curve(SofteningCurve curve, double scale) {
  curve.rate *= scale;
  curve.exp_end /= scale;
  curve.line_end /= scale;
  return curve;
}

/// The rate of decay alone (beta_h = beta h / reference): the strains where the branches meet stay.
/// The rate of a straight loss is its slope, so a curve without exponential scales as a whole.
SofteningCurve scale_decay(SofteningCurve curve, double scale) {
  if (curve.exp_end == 0) return scale_whole_curve(curve, scale);
  curve.rate *= scale;
  return curve;
}

}  // namespace

SofteningCurve softening_curve(const Softening& softening, double peak_strength_Pa, double cell_m) {
  const SofteningCurve curve =
      std::visit([&](const auto& law) { return curve_of(law, peak_strength_Pa); }, softening.law);
  const double scale = cell_m / softening.reference_size_m;
  switch (softening.regularization) {
    case Regularization::beta:
      return scale_decay(curve, scale);
    case Regularization::whole_curve:
      return scale_whole_curve(curve, scale);
    case Regularization::band:
      return scale_whole_curve(curve, softening.band_m / softening.reference_size_m);
    case Regularization::none:
      break;
  }
  return curve;
}

}  // namespace leda::solver
