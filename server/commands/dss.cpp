// leda dss: the direct simple shear test of a material.

#include "solver/element_test/dss.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "server/commands/commands.hpp"
#include "server/commands/element_case.hpp"
#include "server/commands/exit_code.hpp"
#include "server/drawings/curve_drawing.hpp"
#include "solver/element_test/dss_of_particles.hpp"
#include "solver/materials/softening.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

struct DssOptions {
  ElementOptions element;
  std::optional<double> max_strain;
  std::string method = "bare-law";
  double vertical_stress_kPa = 0;
  double rate_per_s = solver::standard_shear_rate;
  int particles_per_cell = 4;
  std::string out;
  std::string svg;
  bool as_json = false;
};

constexpr const char* examples = R"(
Two ways: "bare-law" shears the equations alone, elastic with G up to the peak strength and then the
softening law over the plastic strain; "particles" shears one cell of the solver's particles. Both
scale the law to the cell. Columns of the CSV: shear_strain (elastic and plastic, fraction),
displacement_m (strain x cell), shear_stress_kPa, plastic_strain. Where the element snaps back the
stress drops at one strain.

Examples:
  leda dss case.json --material S1                     as the specimen would be sheared
  leda dss case.json --material S1 --cell 0.5 --method particles --svg dss.svg
  leda dss case.json --material S1 --max-strain 0.4 | leda fit - --remolded-strength-kPa 1)";

double cell_of(const ElementCase& clay, const DssOptions& options) {
  const auto& softening = clay.material.softening;
  return options.element.cell_m.value_or(softening ? softening->reference_size_m
                                                   : clay.case_cell_m);
}

solver::DssCurve shear_law(const ElementCase& clay, const DssOptions& options) {
  const auto& softening = clay.material.softening;
  const double cell = cell_of(clay, options);
  const solver::SofteningCurve law = softening
                                         ? solver::softening_curve(*softening, clay.peak_Pa, cell)
                                         : solver::perfectly_plastic(clay.peak_Pa);
  return solver::dss_of_bare_law({clay.material.shear_modulus_Pa,
                                  solver::at_rate(law, clay.material, options.rate_per_s), cell},
                                 options.max_strain);
}

solver::DssCurve shear(const ElementCase& clay, const DssOptions& options) {
  if (options.method == "bare-law") return shear_law(clay, options);
  return solver::dss_of_particles(
      clay.material, clay.peak_Pa,
      {cell_of(clay, options), options.particles_per_cell, 1000 * options.vertical_stress_kPa,
       options.max_strain, options.rate_per_s});
}

/// What belongs to the other way of shearing would be taken and ignored: it is refused.
std::vector<std::string> faults_of(const ElementCase& clay, const DssOptions& options,
                                   const CLI::App& command) {
  std::vector<std::string> faults;
  if (command.count("--rate-per-s") > 0 && !clay.material.rate && !clay.material.flow) {
    faults.emplace_back("--rate-per-s is for a material with a rate or a flow law");
  }
  if (options.method == "bare-law") {
    for (const char* name : {"--vertical-stress-kPa", "--particles-per-cell"}) {
      if (command.count(name) > 0) {
        faults.push_back(std::string(name) + " is for --method particles only");
      }
    }
    return faults;
  }
  const double before_shear = (1 - clay.material.k0) / 2 * options.vertical_stress_kPa;
  if (1000 * std::abs(before_shear) >= clay.peak_Pa) {
    faults.push_back(fmt::format(
        "--vertical-stress-kPa {:g} with k0 = {:g} is a shear of {:g} kPa before the test: must be "
        "below the peak of {:g} kPa",
        options.vertical_stress_kPa, clay.material.k0, before_shear, clay.peak_Pa / 1000));
  }
  return faults;
}

std::string as_csv(const solver::DssCurve& curve) {
  std::string csv = "shear_strain,displacement_m,shear_stress_kPa,plastic_strain\n";
  for (const auto& p : curve.points) {
    csv += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", p.strain, p.strain * curve.height_m,
                       p.stress_Pa / 1000, p.plastic_strain);
  }
  return csv;
}

json as_json(const ElementCase& clay, const std::string& method, const solver::DssCurve& curve) {
  json strain = json::array(), stress = json::array(), plastic = json::array();
  for (const auto& p : curve.points) {
    strain.push_back(p.strain);
    stress.push_back(p.stress_Pa / 1000);
    plastic.push_back(p.plastic_strain);
  }
  return {{"material", clay.name},
          {"method", method},
          {"cell_m", curve.height_m},
          {"peak_strength_kPa", clay.peak_Pa / 1000},
          {"shear_modulus_kPa", clay.material.shear_modulus_Pa / 1000},
          {"warnings", clay.warnings},
          {"snaps_back", curve.snaps_back},
          {"work_kN_m", solver::work_per_area(curve) / 1000},
          {"shear_strain", strain},
          {"shear_stress_kPa", stress},
          {"plastic_strain", plastic}};
}

DrawnCurve drawn(const std::string& label, const solver::DssCurve& curve) {
  DrawnCurve line{label, {}, {}};
  for (const auto& p : curve.points) {
    line.strain.push_back(p.strain);
    line.stress_Pa.push_back(p.stress_Pa);
  }
  return line;
}

/// The solver's curve with the bare law beside it; the bare law alone.
std::string drawing(const ElementCase& clay, const DssOptions& options,
                    const solver::DssCurve& curve) {
  std::vector<DrawnCurve> curves{drawn(options.method, curve)};
  if (options.method != "bare-law") curves.push_back(drawn("bare-law", shear_law(clay, options)));
  return draw_curves(
      fmt::format("Direct simple shear of {}, cell {:g} m", clay.name, curve.height_m), curves);
}

int run(const DssOptions& options, const CLI::App& command) {
  const auto clay = read_element_case(options.element);
  if (!clay) return 2;
  const auto faults = faults_of(*clay, options, command);
  print_faults("dss", faults);
  if (!faults.empty()) return 2;
  const solver::DssCurve curve = shear(*clay, options);
  if (curve.snaps_back) {
    fmt::print(stderr,
               "note: the law loses strength faster than G = {:g} kPa unloads: the stress drops at "
               "one strain\n",
               clay->material.shear_modulus_Pa / 1000);
  }
  if (!options.svg.empty() && !write_text(options.svg, drawing(*clay, options, curve))) return 2;
  const std::string text =
      options.as_json ? as_json(*clay, options.method, curve).dump(2) + "\n" : as_csv(curve);
  return write_text(options.out, text) ? 0 : 2;
}

}  // namespace

void add_dss(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("dss", "direct simple shear test of a material, as CSV");
  auto options = std::make_shared<DssOptions>();
  add_element_options(*command, options->element, false);
  command
      ->add_option("--method", options->method,
                   "bare-law (the equations) or particles (the solver)")
      ->check(CLI::IsMember({"bare-law", "particles"}));
  command
      ->add_option("--max-strain", options->max_strain,
                   "shear strain to stop at, fraction; default: where the law ends")
      ->check(CLI::Range(1e-6, 100.0));
  command
      ->add_option("--vertical-stress-kPa", options->vertical_stress_kPa,
                   "consolidation under this and k0 times it; default 0")
      ->check(CLI::Range(0.0, 1e5));
  command
      ->add_option("--rate-per-s", options->rate_per_s,
                   "shear strain rate, 1/s; default 1.39e-5 (5 % in an hour)")
      ->check(CLI::Range(1e-12, 1e6));
  command
      ->add_option("--particles-per-cell", options->particles_per_cell, "1, 4, 9 or 16; default 4")
      ->check(CLI::IsMember({1, 4, 9, 16}));
  command->add_option("--out", options->out, "file for the curve; default: standard output");
  command->add_option("--svg", options->svg, "also a drawing, into this file");
  command->add_flag("--json", options->as_json, "JSON instead of CSV");
  command->footer(examples);
  command->callback([options, command, &exit_code] {
    exit_code = guarded([&] { return run(*options, *command); });
  });
}

}  // namespace leda::server
