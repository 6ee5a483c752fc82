#pragma once
// Sections and sites that the tests of screening start from.

#include <cmath>
#include <numbers>
#include <string>

#include "solver/screening/site.hpp"
#include "solver/section/section.hpp"
#include "tests/element/table.hpp"

namespace leda::test {

inline Layer layer_of(const std::string& material) {
  Layer layer;
  layer.material = material;
  return layer;
}

inline Material clay_of(double unit_weight, double strength_Pa) {
  Material m;
  m.unit_weight = unit_weight;
  m.shear_modulus_Pa = 100 * strength_Pa;
  m.poisson_ratio = 0.45;
  m.peak_strength.constant_Pa = strength_Pa;
  return m;
}

/// A plane bank falling rightwards, of one clay, on a firm base at depth_factor times the height.
///
///    H ------.
///             `.  slope_deg
///    0          `--------
///    ==================== base
inline Section plane_bank(double height, double slope_deg, double depth_factor,
                          const Material& clay) {
  Section s;
  s.name = "plane bank";
  const double run = slope_deg > 89.99 ? 0 : height / std::tan(slope_deg * std::numbers::pi / 180);
  const double level = 8 * height;
  s.ground = {{0, height}, {level, height}, {level + run, 0}, {2 * level + run, 0}};
  s.base_m = -(depth_factor - 1) * height;
  s.materials["clay"] = clay;
  s.layers = {layer_of("clay")};
  return s;
}

/// The same section seen from the other side of the page.
inline Section mirrored(Section s) {
  const double width = s.ground.front().x + s.ground.back().x;
  const auto flip = [&](Polyline& line) {
    Polyline other(line.rbegin(), line.rend());
    for (Point& p : other) p.x = width - p.x;
    line = other;
  };
  flip(s.ground);
  for (Layer& layer : s.layers) flip(layer.bottom);
  if (s.water_table) flip(s.water_table->line);
  return s;
}

/// A row of Tables 3-3 and 3-4 as a site; beta is printed per per cent and negative.
inline solver::Site site_of_row(const Row& row) {
  solver::Site site;
  site.height_m = row["height_m"];
  site.unit_weight = 1000 * row["unit_weight_kN_m3"];
  site.peak_strength_Pa = 1000 * row["peak_kPa"];
  site.remolded_strength_Pa = 1000 * row["remolded_kPa"];
  site.peak_strain = row["peak_strain_percent"] / 100;
  site.softening = solver::SiteSoftening{row["alpha"], -100 * row["beta_per_percent"],
                                         row["residual_strain_percent"] / 100};
  site.plasticity_index = row["plasticity_index_percent"] / 100;
  site.liquidity_index = row["liquidity_index"];
  return site;
}

}  // namespace leda::test
