#include "tests/service/region_on_a_bank.hpp"

#include <algorithm>
#include <fstream>

namespace leda::tests {

void write_bank(const std::filesystem::path& file) {
  std::ofstream out(file);
  out << "ncols 300\nnrows 200\nxllcorner 380000\nyllcorner 5113000\ncellsize 2\n"
         "NODATA_value -9999\n";
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 300; ++column) {
      const double x = 2 * column + 1;
      const bool hole = row > 180 && column > 250;
      out << (hole ? -9999 : 20 - 12 * std::clamp((x - 300) / 20, 0.0, 1.0)) << ' ';
    }
    out << '\n';
  }
}

nlohmann::json bank_region() {
  return nlohmann::json::parse(R"({"inputs": {
    "name": "a bank", "dem": "bank",
    "sections": [
      {"name": "AA'", "line": [[380200, 5113100], [380380, 5113100]]},
      {"name": "BB'", "line": [[380200, 5113300], [380380, 5113300]]},
      {"along": [[380300, 5113120], [380300, 5113280]], "spacing_m": 80,
       "upslope_m": 100, "downslope_m": 80}],
    "soil": {
      "base_m": 0, "water_table": {"depth_m": 0},
      "layers": [{"material": "crust", "thickness_m": 2}, {"material": "clay"}],
      "materials": {
        "crust": {"unit_weight_kN_m3": 18, "youngs_modulus_kPa": 10000, "poisson_ratio": 0.45,
                  "peak_strength_kPa": 60, "k0": 0.5},
        "clay": {"unit_weight_kN_m3": 17, "shear_modulus_kPa": 3000, "poisson_ratio": 0.45,
                 "peak_strength_kPa": 40, "k0": 0.5,
                 "softening": {"law": "urmi", "alpha": 0.95, "beta": 2.8, "residual_strain": 1.8,
                               "remolded_strength_kPa": 1, "reference_size_m": 0.014}}}},
    "trigger": {"kind": "undrained", "then_toe_cut_m": 3},
    "resolution": {"cell_m": 2, "particles_per_cell": 4},
    "screening": {"skip_stable": false},
    "stop": {"max_time_s": 60}}})");
}

}  // namespace leda::tests
