#include "server/commands/fit_report.hpp"

#include <fmt/format.h>

#include <cmath>

#include "server/documents/softening_names.hpp"
#include "server/drawings/curve_drawing.hpp"
#include "solver/materials/softening.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

json as_json(const solver::Goodness& goodness) {
  return {{"r2", goodness.r2}, {"rmse_kPa", goodness.rmse_Pa / 1000}, {"points", goodness.points}};
}

/// Six digits: what a test can tell, and what a person can read.
double rounded(double value) { return value > 0 ? std::stod(fmt::format("{:.6g}", value)) : value; }

Softening for_case_file(UrmiSoftening law, double specimen_m) {
  law.alpha = rounded(law.alpha);
  law.beta = rounded(law.beta);
  law.residual_strain = rounded(law.residual_strain);
  law.residual_strength_Pa = rounded(*law.residual_strength_Pa);
  law.remolded_strain = rounded(*law.remolded_strain);
  return {law, specimen_m};
}

std::vector<double> predicted(const SofteningLaw& law, const Fits& fits,
                              const std::vector<double>& strains) {
  Softening softening{law};
  softening.regularization = Regularization::none;
  const auto curve = solver::softening_curve(softening, fits.curve.peak_Pa, 1);
  std::vector<double> stress;
  stress.reserve(strains.size());
  for (const double strain : strains) stress.push_back(solver::strength(curve, strain));
  return stress;
}

}  // namespace

json fit_document(const Fits& fits, const FitOptions& options) {
  const auto& urmi = fits.urmi;
  const auto& other = fits.strain_95;
  json out{{"peak_strength_kPa", fits.curve.peak_Pa / 1000},
           {"peak_strain", fits.curve.peak_strain},
           {"shear_modulus_kPa", fits.curve.shear_modulus_Pa / 1000},
           {"strain", options.strain},
           {"reduction", urmi.reduction},
           {"warnings", fits.warnings}};
  out["urmi"] = {{"softening", to_document(Softening{urmi.law, options.specimen_m})},
                 {"alpha_standard_error", urmi.alpha_error},
                 {"beta_standard_error", urmi.beta_error},
                 {"alpha_trend_line", urmi.alpha_trend_line},
                 {"beta_trend_line", urmi.beta_trend_line},
                 {"residual_strain_from", urmi.residual_strain_from_test ? "test" : "exponential"},
                 {"remolded_strain_from", urmi.remolded_strain_from_test ? "test" : "eq. 3-13"},
                 {"goodness", as_json(urmi.goodness)},
                 {"warnings", urmi.warnings}};
  if (!other.faults.empty()) return out;
  out["einav_randolph"] = {{"softening", to_document(Softening{other.law, options.specimen_m})},
                           {"remolded_strain", other.remolded_strain},
                           {"sensitivity", other.sensitivity},
                           {"strain_used", other.strain_used},
                           {"reduction_used", other.reduction_used},
                           {"goodness", as_json(other.goodness)},
                           {"warnings", other.warnings}};
  return out;
}

void print_fits(const Fits& fits, const FitOptions& options) {
  const auto& urmi = fits.urmi;
  const auto& other = fits.strain_95;
  fmt::print(
      "peak {:.4g} kPa at a strain of {:.4g}, G = {:.5g} kPa; {} points behind it reach "
      "{:.0f} % of the loss\n\n",
      fits.curve.peak_Pa / 1000, fits.curve.peak_strain, fits.curve.shear_modulus_Pa / 1000,
      fits.curve.strain.size(), 100 * urmi.reduction);
  fmt::print("Urmi et al. (thesis 3.4.3), over {} strain\n", options.strain);
  fmt::print("  alpha              {:.4g} +- {:.2g}   (trend line {:.4g})\n", urmi.law.alpha,
             urmi.alpha_error, urmi.alpha_trend_line);
  fmt::print("  beta               {:.4g} +- {:.2g}   (trend line {:.4g})\n", urmi.law.beta,
             urmi.beta_error, urmi.beta_trend_line);
  fmt::print("  residual strength  {:.4g} kPa\n", *urmi.law.residual_strength_Pa / 1000);
  fmt::print("  residual strain    {:.4g}   (from the {})\n", urmi.law.residual_strain,
             urmi.residual_strain_from_test ? "test" : "exponential");
  fmt::print("  remolded strain    {:.4g}   (from {})\n", *urmi.law.remolded_strain,
             urmi.remolded_strain_from_test ? "the test" : "eq. 3-13");
  fmt::print("  R2 {:.5f}, RMSE {:.4g} kPa over {} points\n", urmi.goodness.r2,
             urmi.goodness.rmse_Pa / 1000, urmi.goodness.points);
  if (other.faults.empty()) {
    fmt::print("\nEinav and Randolph (first appendix), from {:.0f} % of the loss at {:.4g}\n",
               100 * other.reduction_used, other.strain_used);
    fmt::print("  strain_95          {:.4g}\n  remolded strain    {:.4g}\n", other.law.strain_95,
               other.remolded_strain);
    fmt::print("  R2 {:.5f}, RMSE {:.4g} kPa over {} points\n", other.goodness.r2,
               other.goodness.rmse_Pa / 1000, other.goodness.points);
  }
  fmt::print("\nFor the case file:\n\"softening\": {}\n",
             to_document(for_case_file(urmi.law, options.specimen_m)).dump());
}

std::string fit_table(const Fits& fits, const FitOptions& options) {
  const auto urmi = predicted(fits.urmi.law, fits, fits.curve.strain);
  const auto other = predicted(fits.strain_95.law, fits, fits.curve.strain);
  const bool both = fits.strain_95.faults.empty();
  std::string csv = fmt::format("{}_strain,measured_kPa,urmi_kPa{}\n", options.strain,
                                both ? ",einav_randolph_kPa" : "");
  for (std::size_t i = 0; i < urmi.size(); ++i) {
    csv += fmt::format("{:.9g},{:.9g},{:.9g}", fits.curve.strain[i], fits.curve.stress_Pa[i] / 1000,
                       urmi[i] / 1000);
    csv += both ? fmt::format(",{:.9g}\n", other[i] / 1000) : "\n";
  }
  return csv;
}

std::string fit_drawing(const Fits& fits, const FitOptions& options) {
  std::vector<double> strains;
  const double end = 1.2 * *fits.urmi.law.remolded_strain;
  const int count = static_cast<int>(std::ceil(std::log(end / 1e-3) / std::log(1.02)));
  for (int i = 0; i < count; ++i) strains.push_back(1e-3 * std::pow(1.02, i));
  std::vector<DrawnCurve> curves{{"test", fits.curve.strain, fits.curve.stress_Pa, true},
                                 {"Urmi et al.", strains, predicted(fits.urmi.law, fits, strains)}};
  if (fits.strain_95.faults.empty()) {
    curves.push_back({"Einav-Randolph", strains, predicted(fits.strain_95.law, fits, strains)});
  }
  return draw_curves("Behind the peak, over " + options.strain + " strain", curves);
}

}  // namespace leda::server
