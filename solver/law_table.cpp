#include "solver/law_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/materials/softening.hpp"

namespace leda::solver {

namespace {
constexpr int strength_steps = 1000;  // of the largest strength: a rounding of at most 0.05 %

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double beyond_reach = 1e30;  // Pa: no stress gets there

SofteningCurve perfectly_plastic(double peak) {
  SofteningCurve curve;
  curve.peak = curve.floor = peak;
  curve.exp_end = curve.line_end = endless;
  return curve;
}

double p_wave_speed(const Material& m) {
  const double bulk = m.youngs_modulus_Pa() / (3 * (1 - 2 * m.poisson_ratio));
  return std::sqrt((bulk + 4.0 / 3.0 * m.shear_modulus_Pa) / (m.unit_weight / gravity));
}
}  // namespace

SofteningCurve LawTable::curve(std::size_t row) const {
  return {peak[row],    floor[row],      amplitude[row], rate[row],
          exp_end[row], line_start[row], line_end[row],  last[row]};
}

LawTableBuilder::LawTableBuilder(const Section& section, double cell_m) : cell_m_(cell_m) {
  for (const auto& [name, material] : section.materials) {
    materials_.push_back(&material);
    rows_.emplace_back(strength_steps + 1, -1);
  }
}

std::int32_t LawTableBuilder::row(std::size_t material_index, double depth_m, double elevation_m) {
  const Strength& strength = materials_[material_index]->peak_strength;
  const double largest = strength.largest();
  const double step = strength.at(depth_m, elevation_m) / largest * strength_steps;
  const auto bin = static_cast<std::size_t>(std::clamp(std::lround(step), 1L, 1L * strength_steps));
  std::int32_t& known = rows_[material_index][bin];
  if (known < 0) known = add(material_index, largest * static_cast<double>(bin) / strength_steps);
  return known;
}

std::int32_t LawTableBuilder::add(std::size_t material_index, double peak) {
  const Material& m = *materials_[material_index];
  SofteningCurve curve = perfectly_plastic(peak);
  if (m.softening) curve = softening_curve(*m.softening, peak, cell_m_);
  LawTable& t = table_;
  t.bulk.push_back(m.youngs_modulus_Pa() / (3 * (1 - 2 * m.poisson_ratio)));
  t.shear.push_back(m.shear_modulus_Pa);
  t.peak.push_back(peak);
  t.floor.push_back(curve.floor);
  t.amplitude.push_back(curve.amplitude);
  t.rate.push_back(curve.rate);
  t.exp_end.push_back(curve.exp_end);
  t.line_start.push_back(curve.line_start);
  const double length = curve.line_end - curve.exp_end;
  const bool has_line = std::isfinite(length) && length > 0;
  t.line_slope.push_back(has_line ? (curve.last - curve.line_start) / length : 0.0);
  t.line_end.push_back(curve.line_end);
  t.last.push_back(curve.last);
  t.softens.push_back(m.softening ? 1 : 0);
  t.material.push_back(static_cast<std::int32_t>(material_index));
  t.stiffest_speed = std::max(t.stiffest_speed, p_wave_speed(m));
  return static_cast<std::int32_t>(t.rows() - 1);
}

LawTable without_softening(const LawTable& table, bool elastic) {
  LawTable result = table;
  std::fill(result.softens.begin(), result.softens.end(), 0);
  if (elastic) std::fill(result.peak.begin(), result.peak.end(), beyond_reach);
  result.floor = result.peak;
  std::fill(result.amplitude.begin(), result.amplitude.end(), 0.0);
  std::fill(result.exp_end.begin(), result.exp_end.end(), endless);
  std::fill(result.line_end.begin(), result.line_end.end(), endless);
  return result;
}

}  // namespace leda::solver
