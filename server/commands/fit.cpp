// leda fit: softening parameters from a curve of the laboratory.

#include <fmt/format.h>

#include <fstream>
#include <iostream>

#include "server/commands/commands.hpp"
#include "server/commands/element_case.hpp"
#include "server/commands/exit_code.hpp"
#include "server/commands/fit_report.hpp"
#include "server/documents/warning_lines.hpp"
#include "solver/element_test/energy_curve.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

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

solver::LabFile read(const FitOptions& options) {
  if (options.file == "-") return solver::read_lab_file(std::cin);
  std::ifstream in(options.file);
  if (in) return solver::read_lab_file(in);
  return {.stress_strain = {}, .energy = {}, .faults = {"cannot be read"}};
}

void check_energy(const solver::EnergyCurve& energy, const FitOptions& options,
                  std::vector<std::string>& faults) {
  if (!options.peak_kPa)
    faults.emplace_back("--peak-strength-kPa is missing: an energy curve has none");
  if (!options.preconsolidation_kPa) {
    faults.emplace_back(
        "--preconsolidation-kPa is missing: energies are multiples of 0.013 times it");
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
    faults.emplace_back(
        "--peak-strength-kPa: the curve has its own peak; only energy curves need one");
  }
  if (options.preconsolidation_kPa) {
    faults.emplace_back("--preconsolidation-kPa is for energy curves only");
  }
}

std::optional<solver::LabCurve> lab_curve(const FitOptions& options,
                                          std::vector<std::string>& faults) {
  const solver::LabFile file = read(options);
  for (const auto& fault : file.faults) faults.push_back(options.file + ": " + fault);
  if (options.residual_kPa && options.fit_residual) {
    faults.emplace_back("--residual-strength-kPa and --fit-residual-strength exclude each other");
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

/// The clay as a case would have it; what no shear test tells is as clays have it.
Material clay_of(const Fits& fits, const FitOptions& options) {
  constexpr double usual_unit_weight = 17e3, usual_poisson_ratio = 0.45;
  Material clay;
  clay.unit_weight = usual_unit_weight;
  clay.poisson_ratio = usual_poisson_ratio;
  clay.shear_modulus_Pa = fits.curve.shear_modulus_Pa;
  clay.peak_strength.constant_Pa = fits.curve.peak_Pa;
  clay.softening = Softening{fits.urmi.law, options.specimen_m};
  return clay;
}

Fits fit(const solver::LabCurve& curve, const FitOptions& options) {
  const auto measure = options.strain == "total" ? StrainMeasure::total : StrainMeasure::plastic;
  Fits fits{solver::behind_peak(curve, measure), {}, {}, {}};
  solver::UrmiFitInput input;
  input.curve = fits.curve;
  input.remolded_Pa = 1000 * options.remolded_kPa;
  if (options.residual_kPa) input.residual_Pa = 1000 * *options.residual_kPa;
  input.fit_residual = options.fit_residual;
  input.residual_share = options.residual_share_percent / 100;
  fits.urmi = solver::fit_urmi(input);
  fits.strain_95 = solver::fit_strain_95(fits.curve, 1000 * options.remolded_kPa);
  if (fits.urmi.faults.empty()) fits.warnings = warnings_of({{"fitted", clay_of(fits, options)}});
  return fits;
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
    fmt::print("{}\n", fit_document(fits, options).dump(2));
  } else {
    print_fits(fits, options);
  }
  for (const auto* warnings : {&fits.urmi.warnings, &fits.strain_95.warnings, &fits.warnings}) {
    fmt::print(stderr, "{}", warning_lines(*warnings));
  }
  if (!options.out.empty() && !write_text(options.out, fit_table(fits, options))) return 2;
  if (!options.svg.empty() && !write_text(options.svg, fit_drawing(fits, options))) return 2;
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
