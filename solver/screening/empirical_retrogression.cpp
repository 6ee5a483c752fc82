#include "solver/screening/empirical_retrogression.hpp"

#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>

namespace leda::solver {
namespace {

std::string number(double value) {
  char text[32];
  const auto end =
      std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, 4);
  return {std::begin(text), end.ptr};
}

}  // namespace

Estimate urmi_2023(double potential_J, double remolding_J, double liquidity_index,
                   double unit_weight, const OmegaLine& line) {
  const double omega = line.at(liquidity_index, unit_weight);
  if (omega <= 0) {
    return {{},
            {},
            "omega = " + number(omega) +
                " is not positive: I_L m = " + number(liquidity_index * unit_weight / 1000) +
                " kN/m3 lies outside the sites it was fitted to"};
  }
  const double left_kPa = (potential_J - remolding_J) / 1000;
  if (left_kPa <= 0) return {{}, {}, "the remolding energy exceeds the potential energy"};
  Estimate estimate{left_kPa / omega, {}, {}};
  if (omega > line.spread) {
    estimate.range = {left_kPa / (omega + line.spread), left_kPa / (omega - line.spread)};
  }
  return estimate;
}

double quinn_2011(double height_m, double slope_angle_deg) {
  return height_m / (6 * std::sin(slope_angle_deg * std::numbers::pi / 180));
}

std::array<double, 2> carson_lajoie_1981(double height_m) { return {4 * height_m, 27 * height_m}; }

Estimate mitchell_markell_1974(double stability_number) {
  if (stability_number < 6) {
    return {{}, {}, "N_s = " + number(stability_number) + " < 6: no retrogression"};
  }
  return {100 * (stability_number - 4), {}, {}};
}

double nve_1_15(double height_m) { return 15 * height_m; }

}  // namespace leda::solver
