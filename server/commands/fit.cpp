// leda fit: softening parameters from a curve of the laboratory.

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "server/commands/commands.hpp"
#include "server/commands/curve_drawing.hpp"
#include "server/commands/element_case.hpp"
#include "server/commands/exit_code.hpp"
#include "server/documents/softening_names.hpp"
#include "solver/element_test/energy_curve.hpp"
#include "solver/element_test/fit_strain_95.hpp"
#include "solver/element_test/fit_urmi.hpp"
#include "solver/materials/softening.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::StrainMeasure;

constexpr const char* examples = R"(
The CSV has a header line: shear_strain (or shear_strain_percent) and shear_stress_kPa; or, for a
remolding test, normalized_energy (W / w_LS, 1 at the peak) and remolding_index (or ..._percent),
which eq. 3-6 of the thesis turns into stress over strain with --peak-strength-kPa and
--preconsolidation-kPa. Other columns, empty lines and lines starting with # are passed over.

Two laws come out: that of Urmi et al. (alpha, beta, residual and remolded strain; thesis 3.4.3)
and strain_95 of Einav and Randolph from the point at 50 % of the loss (first appendix).
The strain is the plastic one, as the simulation counts it; --strain total fits as the thesis plots.

Examples:
  leda fit dss.csv --remolded-strength-kPa 0.74
  leda fit dss.csv --remolded-strength-kPa 0.74 --strain total --json
  leda fit tavenas.csv --remolded-strength-kPa 1.3 --peak-strength-kPa 39 --preconsolidation-kPa 125 \
      --fit-residual-strength --out curve.csv --svg curve.svg)";

struct FitOptions {
  std::string file;
  double remolded_kPa = 0;
  std::optional<double> residual_kPa;
  std::optional<double> peak_kPa;
  std::optional<double> preconsolidation_kPa;
  double residual_share_percent = 100 * solver::residual_share_of_table_3_4;
  double specimen_m = 0.014;
  bool fit_residual = false;
  std::string strain = "plastic";
  std::string out;
  std::string svg;
  bool as_json = false;
};

struct Fits {
  solver::PostPeak curve;
  solver::UrmiFit urmi;
  solver::Strain95Fit strain_95;
};

solver::LabFile read(const FitOptions& options) {
  if (options.file == "-") return solver::read_lab_file(std::cin);
  std::ifstream in(options.file);
  if (in) return solver::read_lab_file(in);
  return {.stress_strain = {}, .energy = {}, .faults = {"cannot be read"}};
}

void check_energy(const solver::EnergyCurve& energy, const FitOptions& options,
                  std::vector<std::string>& faults) {
  if (!options.peak_kPa)
    faults.push_back("--peak-strength-kPa is missing: an energy curve has none");
  if (!options.preconsolidation_kPa) {
    faults.push_back("--preconsolidation-kPa is missing: energies are multiples of 0.013 times it");
  }
  for (std::size_t i = 0; i < energy.remolding_index.size(); ++i) {
    if (energy.remolding_index[i] > 1 || energy.normalized_energy[i] < 1) {
      faults.push_back(
          fmt::format("row {}: remolding index {:g} (0 to 1), normalized energy {:g} (1 at the "
                      "peak, then more)",
                      i + 1, energy.remolding_index[i], energy.normalized_energy[i]));
      return;
    }
  }
}

void check_stress_strain(const FitOptions& options, std::vector<std::string>& faults) {
  if (options.peak_kPa) {
    faults.push_back(
        "--peak-strength-kPa: the curve has its own peak; only energy curves need one");
  }
  if (options.preconsolidation_kPa) {
    faults.push_back("--preconsolidation-kPa is for energy curves only");
  }
}

std::optional<solver::LabCurve> lab_curve(const FitOptions& options,
                                          std::vector<std::string>& faults) {
  const solver::LabFile file = read(options);
  for (const auto& fault : file.faults) faults.push_back(options.file + ": " + fault);
  if (options.residual_kPa && options.fit_residual) {
    faults.push_back("--residual-strength-kPa and --fit-residual-strength exclude each other");
  }
  if (file.energy) check_energy(*file.energy, options, faults);
  if (file.stress_strain) check_stress_strain(options, faults);
  if (faults.empty() && file.energy) {
    return solver::to_stress_strain(*file.energy, 1000 * *options.peak_kPa,
                                    1000 * options.remolded_kPa,
                                    1000 * *options.preconsolidation_kPa);
  }
  if (faults.empty() && file.stress_strain->strain.empty()) {
    faults.push_back(options.file + ": no row behind the header");
  }
  if (!faults.empty()) return {};
  return file.stress_strain;
}

Fits fit(const solver::LabCurve& curve, const FitOptions& options) {
  const auto measure = options.strain == "total" ? StrainMeasure::total : StrainMeasure::plastic;
  Fits fits{solver::behind_peak(curve, measure), {}, {}};
  solver::UrmiFitInput input;
  input.curve = fits.curve;
  input.remolded_Pa = 1000 * options.remolded_kPa;
  if (options.residual_kPa) input.residual_Pa = 1000 * *options.residual_kPa;
  input.fit_residual = options.fit_residual;
  input.residual_share = options.residual_share_percent / 100;
  fits.urmi = solver::fit_urmi(input);
  fits.strain_95 = solver::fit_strain_95(fits.curve, 1000 * options.remolded_kPa);
  return fits;
}

json as_json(const solver::Goodness& goodness) {
  return {{"r2", goodness.r2}, {"rmse_kPa", goodness.rmse_Pa / 1000}, {"points", goodness.points}};
}

json document(const Fits& fits, const FitOptions& options) {
  const auto& urmi = fits.urmi;
  const auto& other = fits.strain_95;
  json out{{"peak_strength_kPa", fits.curve.peak_Pa / 1000},
           {"peak_strain", fits.curve.peak_strain},
           {"shear_modulus_kPa", fits.curve.shear_modulus_Pa / 1000},
           {"strain", options.strain},
           {"reduction", urmi.reduction}};
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

std::vector<double> predicted(const SofteningLaw& law, const Fits& fits,
                              const std::vector<double>& strains) {
  Softening softening{law};
  softening.regularization = Regularization::none;
  const auto curve = solver::softening_curve(softening, fits.curve.peak_Pa, 1);
  std::vector<double> stress;
  for (const double strain : strains) stress.push_back(solver::strength(curve, strain));
  return stress;
}

bool write(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text << std::flush;
  if (!out) fmt::print(stderr, "{}: cannot be written\n", path);
  return static_cast<bool>(out);
}

std::string table(const Fits& fits, const FitOptions& options) {
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

std::string drawing(const Fits& fits, const FitOptions& options) {
  std::vector<double> strains;
  const double end = 1.2 * *fits.urmi.law.remolded_strain;
  for (double s = 1e-3; s < end; s *= 1.02) strains.push_back(s);
  std::vector<DrawnCurve> curves{{"test", fits.curve.strain, fits.curve.stress_Pa, true},
                                 {"Urmi et al.", strains, predicted(fits.urmi.law, fits, strains)}};
  if (fits.strain_95.faults.empty()) {
    curves.push_back({"Einav-Randolph", strains, predicted(fits.strain_95.law, fits, strains)});
  }
  return draw_curves("Behind the peak, over " + options.strain + " strain", curves);
}

int run(const FitOptions& options) {
  std::vector<std::string> faults;
  const auto curve = lab_curve(options, faults);
  Fits fits;
  if (curve) {
    fits = fit(*curve, options);
    faults = fits.urmi.faults;
  }
  if (!faults.empty()) {
    print_faults("fit", faults);
    return 2;
  }
  if (options.as_json) {
    fmt::print("{}\n", document(fits, options).dump(2));
  } else {
    print_fits(fits, options);
  }
  for (const auto& warning : fits.urmi.warnings) fmt::print(stderr, "warning: {}\n", warning);
  for (const auto& warning : fits.strain_95.warnings) fmt::print(stderr, "warning: {}\n", warning);
  if (!options.out.empty() && !write(options.out, table(fits, options))) return 2;
  if (!options.svg.empty() && !write(options.svg, drawing(fits, options))) return 2;
  return 0;
}

void add_options(CLI::App& command, FitOptions& o) {
  const auto positive = CLI::Range(1e-6, 1e6);
  command.add_option("curve", o.file, "CSV of the curve; - reads standard input")->required();
  command.add_option("--remolded-strength-kPa", o.remolded_kPa, "s_ur, of a fall cone for example")
      ->required()
      ->check(positive);
  command
      .add_option("--residual-strength-kPa", o.residual_kPa,
                  "s_uR; default: 0.095 times the peak (eq. 3-11)")
      ->check(positive);
  command.add_flag("--fit-residual-strength", o.fit_residual,
                   "s_uR is fitted too: for tests that reach it");
  command
      .add_option("--residual-share", o.residual_share_percent,
                  "percent of (s_up - s_uR) left where residual_strain is read, default 0.33")
      ->check(CLI::Range(1e-3, 20.0));
  command.add_option("--peak-strength-kPa", o.peak_kPa, "s_up, for energy curves")->check(positive);
  command
      .add_option("--preconsolidation-kPa", o.preconsolidation_kPa, "sigma'_p, for energy curves")
      ->check(positive);
  command
      .add_option("--strain", o.strain, "strain to fit over: plastic (the simulation's) or total")
      ->check(CLI::IsMember({"plastic", "total"}));
  command.add_option("--specimen-m", o.specimen_m, "height of the specimen, m, default 0.014")
      ->check(CLI::Range(1e-4, 10.0));
  command.add_option("--out", o.out, "file for measured and fitted stress, CSV");
  command.add_option("--svg", o.svg, "file for a drawing");
  command.add_flag("--json", o.as_json, "machine-readable output");
}

}  // namespace

void add_fit(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("fit", "softening parameters from a laboratory curve");
  auto options = std::make_shared<FitOptions>();
  add_options(*command, *options);
  command->footer(examples);
  command->callback([options, &exit_code] { exit_code = guarded([&] { return run(*options); }); });
}

}  // namespace leda::server
