// leda calibrate: the softening law of a specimen in a cell, by equal dissipated energy.

#include "solver/element_test/calibrate.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "server/commands/commands.hpp"
#include "server/commands/element_case.hpp"
#include "server/commands/exit_code.hpp"
#include "server/documents/softening_names.hpp"
#include "solver/element_test/dissipation.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::Calibration;

constexpr const char* examples = R"(
A shear band one cell thick shall dissipate what the band in the specimen did. "beta" scales the
decay alone, so that the energy above the residual strength is kept; plateau and tail keep their
strains, and the energy of the whole curve grows with the cell. "whole-curve" scales every strain
and keeps all of it. Both are given in closed form (cell / specimen) and by root finding on the
integrated curve, which must agree. The simulation applies the scaling itself: give the case file
the law of the specimen, not the scaled one.

Examples:
  leda calibrate case.json --material S1 --cell 0.5
  leda calibrate case.json --material S1 --cell 1.0 --json)";

json side(const solver::SofteningCurve& curve, double excess, double total) {
  json out{{"excess_kN_m", excess / 1000}};
  if (curve.exp_end > 0) out["decay_per_strain"] = curve.rate;
  if (solver::has_end(curve)) {
    out["total_kN_m"] = total / 1000;
    out["remolded_strain"] = curve.line_end;
    if (curve.exp_end > 0) out["residual_strain"] = curve.exp_end;
  }
  return out;
}

json as_json(const Calibration& c) {
  json out{{"scale_closed_form", c.scale_closed_form},
           {"scale_numerical", c.scale_numerical ? json(*c.scale_numerical) : json()},
           {"specimen", side(c.reference, c.reference_excess, c.reference_total)},
           {"cell", side(c.cell, c.cell_excess, c.cell_total)},
           {"steepest_loss_kPa", c.steepest_loss_Pa / 1000},
           {"snaps_back", c.snaps_back}};
  if (c.scale_to_residual_strain && c.reference.exp_end > 0) {
    out["decay_by_energy_to_residual_strain"] = c.reference.rate * *c.scale_to_residual_strain;
  }
  return out;
}

json document(const ElementCase& clay, const Calibration& beta, const Calibration& whole) {
  return {{"material", clay.name},
          {"softening", to_document(*clay.material.softening)},
          {"peak_strength_kPa", clay.peak_Pa / 1000},
          {"shear_modulus_kPa", clay.material.shear_modulus_Pa / 1000},
          {"warnings", clay.warnings},
          {"specimen_m", beta.reference_size_m},
          {"cell_m", beta.cell_m},
          {"beta", as_json(beta)},
          {"whole-curve", as_json(whole)}};
}

void row(const char* label, double specimen, double beta, double whole) {
  fmt::print("  {:<38}{:>12.6g}{:>12.6g}{:>14.6g}\n", label, specimen, beta, whole);
}

void print_table(const ElementCase& clay, const Calibration& beta, const Calibration& whole) {
  const auto& lab = beta.reference;
  fmt::print("{}: peak {:g} kPa, specimen {:g} m, cell {:g} m\n\n", clay.name, clay.peak_Pa / 1000,
             beta.reference_size_m, beta.cell_m);
  fmt::print("  {:<38}{:>12}{:>12}{:>14}\n", "", "specimen", "beta", "whole-curve");
  if (lab.exp_end > 0)
    row("decay per unit strain (beta)", lab.rate, beta.cell.rate, whole.cell.rate);
  if (solver::has_end(lab)) {
    if (lab.exp_end > 0) {
      row("residual strain", lab.exp_end, beta.cell.exp_end, whole.cell.exp_end);
    }
    row("remolded strain", lab.line_end, beta.cell.line_end, whole.cell.line_end);
  }
  row("scale, closed form", 1, beta.scale_closed_form, whole.scale_closed_form);
  row("scale, by equal energy", 1, beta.scale_numerical.value_or(0),
      whole.scale_numerical.value_or(0));
  row("energy above residual strength, kN/m", beta.reference_excess / 1000, beta.cell_excess / 1000,
      whole.cell_excess / 1000);
  if (solver::has_end(lab)) {
    row("energy to remolded strain, kN/m", beta.reference_total / 1000, beta.cell_total / 1000,
        whole.cell_total / 1000);
  }
  row("steepest loss, kPa", solver::steepest_loss(lab) / 1000, beta.steepest_loss_Pa / 1000,
      whole.steepest_loss_Pa / 1000);
}

void print_notes(const ElementCase& clay, const Calibration& beta, const Calibration& whole) {
  if (beta.scale_to_residual_strain && beta.reference.exp_end > 0) {
    fmt::print("\nbeta with the energy counted to the residual strain only: {:.6g}\n",
               beta.reference.rate * *beta.scale_to_residual_strain);
  }
  if (beta.snaps_back || whole.snaps_back) {
    fmt::print(
        "note: the steepest loss in the cell exceeds G = {:g} kPa: the cell snaps back, its stress "
        "drops\n      at one strain, and elastic energy is lost that the specimen did not hold\n",
        clay.material.shear_modulus_Pa / 1000);
  }
}

struct CalibrateOptions {
  ElementOptions element;
  bool as_json = false;
};

int run(const CalibrateOptions& options) {
  const auto clay = read_element_case(options.element);
  if (!clay) return 2;
  if (!clay->material.softening) {
    print_faults("calibrate",
                 {"material \"" + clay->name + "\" does not soften: nothing to scale"});
    return 2;
  }
  const auto by = [&](Regularization regularization) {
    Softening softening = *clay->material.softening;
    softening.regularization = regularization;
    return solver::calibrate(softening, clay->peak_Pa, clay->material.shear_modulus_Pa,
                             *options.element.cell_m);
  };
  const Calibration beta = by(Regularization::beta);
  const Calibration whole = by(Regularization::whole_curve);
  if (!beta.scale_numerical) {
    print_faults("calibrate", {"the law dissipates nothing above its last strength"});
    return 2;
  }
  if (options.as_json) {
    fmt::print("{}\n", document(*clay, beta, whole).dump(2));
    return 0;
  }
  print_table(*clay, beta, whole);
  print_notes(*clay, beta, whole);
  return 0;
}

}  // namespace

void add_calibrate(CLI::App& app, int& exit_code) {
  auto* command =
      app.add_subcommand("calibrate", "softening law of a specimen scaled to a cell size");
  auto options = std::make_shared<CalibrateOptions>();
  add_element_options(*command, options->element, true);
  command->add_flag("--json", options->as_json, "machine-readable output");
  command->footer(examples);
  command->callback([options, &exit_code] { exit_code = guarded([&] { return run(*options); }); });
}

}  // namespace leda::server
