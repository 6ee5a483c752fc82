#include "tests/service/region_on_a_bank.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>

namespace leda::tests {

namespace {

constexpr int rows = 200, columns = 300;
constexpr double cell_m = 2;

/// @param elevation of a cell, from the distance eastwards, m, and its row; -9999: none
void write_grid(const std::filesystem::path& file,
                const std::function<double(double, int)>& elevation) {
  std::ofstream out(file);
  out << "ncols " << columns << "\nnrows " << rows
      << "\nxllcorner 380000\nyllcorner 5113000\ncellsize " << cell_m << "\nNODATA_value -9999\n";
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      out << elevation(cell_m * (column + 0.5), row) << ' ';
    }
    out << '\n';
  }
}

double bank(double x, double height_m, double width_m) {
  return 20 - height_m * std::clamp((x - 300) / width_m, 0.0, 1.0);
}

}  // namespace

void write_bank(const std::filesystem::path& file) {
  write_grid(file, [](double x, int row) {
    const bool hole = row > 180 && x > 502;
    return hole ? -9999 : bank(x, 12, 20);
  });
}

void write_wavy_bank(const std::filesystem::path& file) {
  write_grid(file, [](double x, int row) {
    return bank(x, 11 + 2 * std::sin(0.11 * row), 22 + 4 * std::cos(0.07 * row));
  });
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
