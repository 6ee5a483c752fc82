// leda dss: the direct simple shear test of a material.

#include "solver/element_test/dss.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "server/commands/commands.hpp"
#include "server/commands/curve_drawing.hpp"
#include "server/commands/element_case.hpp"
#include "server/commands/exit_code.hpp"
#include "solver/materials/softening.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

struct DssOptions {
  ElementOptions element;
  std::optional<double> max_strain;
  std::string out;
  std::string svg;
  bool as_json = false;
};

constexpr const char* examples = R"(
The law alone is sheared: elastic with G up to the peak strength, then the softening law over the
plastic strain, scaled to the cell. Columns of the CSV: shear_strain (elastic and plastic,
fraction), displacement_m (strain x cell), shear_stress_kPa, plastic_strain. Where the element
snaps back the stress drops at one strain.

Examples:
  leda dss case.json --material S1                     as the specimen would be sheared
  leda dss case.json --material S1 --cell 0.5 --svg dss.svg
  leda dss case.json --material S1 --max-strain 0.4 | leda fit - --remolded-strength-kPa 1)";

solver::DssCurve shear(const ElementCase& clay, const DssOptions& options) {
  const auto& softening = clay.material.softening;
  const double cell =
      options.element.cell_m.value_or(softening ? softening->reference_size_m : clay.case_cell_m);
  const solver::SofteningCurve law = softening
                                         ? solver::softening_curve(*softening, clay.peak_Pa, cell)
                                         : solver::perfectly_plastic(clay.peak_Pa);
  return solver::dss_of_bare_law({clay.material.shear_modulus_Pa, law, cell}, options.max_strain);
}

std::string as_csv(const solver::DssCurve& curve) {
  std::string csv = "shear_strain,displacement_m,shear_stress_kPa,plastic_strain\n";
  for (const auto& p : curve.points) {
    csv += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", p.strain, p.strain * curve.height_m,
                       p.stress_Pa / 1000, p.plastic_strain);
  }
  return csv;
}

json as_json(const ElementCase& clay, const solver::DssCurve& curve) {
  json strain = json::array(), stress = json::array(), plastic = json::array();
  for (const auto& p : curve.points) {
    strain.push_back(p.strain);
    stress.push_back(p.stress_Pa / 1000);
    plastic.push_back(p.plastic_strain);
  }
  return {{"material", clay.name},
          {"method", "bare-law"},
          {"cell_m", curve.height_m},
          {"peak_strength_kPa", clay.peak_Pa / 1000},
          {"shear_modulus_kPa", clay.material.shear_modulus_Pa / 1000},
          {"snaps_back", curve.snaps_back},
          {"work_kN_m", solver::work_per_area(curve) / 1000},
          {"shear_strain", strain},
          {"shear_stress_kPa", stress},
          {"plastic_strain", plastic}};
}

std::string drawing(const ElementCase& clay, const solver::DssCurve& curve) {
  DrawnCurve line{fmt::format("bare law, cell {:g} m", curve.height_m), {}, {}};
  for (const auto& p : curve.points) {
    line.strain.push_back(p.strain);
    line.stress_Pa.push_back(p.stress_Pa);
  }
  return draw_curves("Direct simple shear of " + clay.name, {line});
}

bool write(const std::string& path, const std::string& text) {
  if (path.empty() || path == "-") {
    std::cout << text << std::flush;
    return static_cast<bool>(std::cout);
  }
  std::ofstream out(path, std::ios::binary);
  out << text << std::flush;
  if (!out) fmt::print(stderr, "{}: cannot be written\n", path);
  return static_cast<bool>(out);
}

int run(const DssOptions& options) {
  const auto clay = read_element_case(options.element);
  if (!clay) return 2;
  const solver::DssCurve curve = shear(*clay, options);
  if (curve.snaps_back) {
    fmt::print(stderr,
               "note: the law loses strength faster than G = {:g} kPa unloads: the stress drops at "
               "one strain\n",
               clay->material.shear_modulus_Pa / 1000);
  }
  if (!options.svg.empty() && !write(options.svg, drawing(*clay, curve))) return 2;
  const std::string text = options.as_json ? as_json(*clay, curve).dump(2) + "\n" : as_csv(curve);
  return write(options.out, text) ? 0 : 2;
}

}  // namespace

void add_dss(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("dss", "direct simple shear test of a material, as CSV");
  auto options = std::make_shared<DssOptions>();
  add_element_options(*command, options->element, false);
  command
      ->add_option("--max-strain", options->max_strain,
                   "shear strain to stop at, fraction; default: where the law ends")
      ->check(CLI::Range(1e-6, 1e6));
  command->add_option("--out", options->out, "file for the curve; default: standard output");
  command->add_option("--svg", options->svg, "also a drawing, into this file");
  command->add_flag("--json", options->as_json, "JSON instead of CSV");
  command->footer(examples);
  command->callback([options, &exit_code] { exit_code = guarded([&] { return run(*options); }); });
}

}  // namespace leda::server
