#include "solver/materials/law_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "solver/materials/softening.hpp"
#include "solver/section/model_size.hpp"

namespace leda::solver {

namespace {
constexpr int strength_steps = 1000;  // of the largest strength: a rounding of at most 0.05 %

constexpr double field_steps = 4;  // of a standard deviation of the logarithm
constexpr double least_field_step = 1e-3;
constexpr double field_reach = 5;  // standard deviations; what lies beyond takes the outermost row
constexpr double pressure_step_Pa = 50;
constexpr double no_cohesion_Pa = 1e-3;  // shares of the peak are taken

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double locking_ratio =  // K / G
    2 * (1 + locking_poisson_ratio) / (3 * (1 - 2 * locking_poisson_ratio));
constexpr double no_rate = 1e-300;  // of the reference: its logarithm is still a number

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

SofteningCurve perfectly_plastic(double peak) {
  SofteningCurve curve;
  curve.peak = curve.floor = peak;
  curve.exp_end = curve.line_end = endless;
  return curve;
}

struct RateRow {
  double base = 1, log_share = 0, power_share = 0, exponent = 0, least = 1, reference = 1;
};

void add(const RateRow& row, RateColumns& columns) {
  columns.base.push_back(row.base);
  columns.log_share.push_back(row.log_share);
  columns.power_share.push_back(row.power_share);
  columns.exponent.push_back(row.exponent);
  columns.least.push_back(row.least);
  columns.reference.push_back(row.reference);
}

RateRow rate_row(const SemiLogarithmicRate& law) {
  return {.log_share = law.per_decade / std::numbers::ln10, .reference = law.reference_rate};
}
RateRow rate_row(const PowerRate& law) {
  return {.base = 0, .power_share = 1, .exponent = law.exponent, .reference = law.reference_rate};
}
RateRow rate_row(const AdditivePowerRate& law) {
  return {.power_share = law.viscosity,
          .exponent = law.exponent,
          .least = no_rate,
          .reference = law.reference_rate};
}

/// What the points of a row share.
struct Step {
  long number;
  double peak, pore_pressure;
};

Step step_of_pressure(const Material& m, double pore_pressure) {
  const long number = std::lround(pore_pressure / pressure_step_Pa);
  const double peak = m.drained->cohesion_Pa * std::cos(radians(m.drained->friction_angle_deg));
  return {number, std::max(peak, no_cohesion_Pa), static_cast<double>(number) * pressure_step_Pa};
}

Step step_of_strength(const Material& m, double strength) {
  const double largest = m.peak_strength.largest();
  const long number =
      std::clamp(std::lround(strength / largest * strength_steps), 1L, 1L * strength_steps);
  return {number, largest * static_cast<double>(number) / strength_steps, 0};
}

/// Shear yields first beyond twice the peak, which a random field may bring below what was given.
double tension_of(const Material& m, double peak) {
  if (!m.tensile_strength_Pa) return m.drains ? 0 : beyond_reach;
  return m.drains ? *m.tensile_strength_Pa : std::min(*m.tensile_strength_Pa, 2 * peak);
}

RateRow rate_row(const std::optional<RateLaw>& law) {
  if (!law) return {};
  return std::visit([](const auto& one) { return rate_row(one); }, *law);
}

}  // namespace

SofteningCurve LawTable::curve(std::size_t row) const {
  return {peak[row],    floor[row],      amplitude[row], rate[row],
          exp_end[row], line_start[row], line_end[row],  last[row]};
}

LawTableBuilder::LawTableBuilder(const Section& section, double cell_m) : cell_m_(cell_m) {
  for (const auto& [name, material] : section.materials) {
    materials_.push_back(&material);
    viscous_ = viscous_ || is_viscous(material);
  }
  rows_.resize(materials_.size());
}

std::int32_t LawTableBuilder::row(std::size_t material_index, double depth_m, double elevation_m,
                                  double pore_pressure, double factor) {
  const Material& m = *materials_[material_index];
  const double strength = m.drains ? 0 : m.peak_strength.at(depth_m, elevation_m) * factor;
  if (m.field && !m.drains) return row_of_field(material_index, strength);
  const Step step = m.drains ? step_of_pressure(m, pore_pressure) : step_of_strength(m, strength);
  const auto [known, is_new] = rows_[material_index].try_emplace(step.number, -1);
  if (is_new) known->second = add(material_index, step.peak, step.pore_pressure);
  return known->second;
}

std::int32_t LawTableBuilder::row_of_field(std::size_t material_index, double strength) {
  const auto [known, is_new] = field_rows_.try_emplace(material_index);
  FieldRows& rows = known->second;
  if (is_new) rows = add_rows_of_field(material_index);
  const double largest = materials_[material_index]->peak_strength.largest();
  const long step = std::lround(std::log(strength / largest) / rows.step);
  return rows.first +
         static_cast<std::int32_t>(std::clamp(step, rows.lowest, rows.highest) - rows.lowest);
}

LawTableBuilder::FieldRows LawTableBuilder::add_rows_of_field(std::size_t material_index) {
  const Material& m = *materials_[material_index];
  const double sd = sd_of_logarithm(*m.field), largest = m.peak_strength.largest();
  const double least = std::log(m.peak_strength.smallest() / largest);
  FieldRows rows;
  rows.step = std::max(sd / field_steps, least_field_step);
  rows.lowest = std::lround((least - field_reach * sd) / rows.step);
  rows.highest = std::lround(field_reach * sd / rows.step);
  rows.first = static_cast<std::int32_t>(table_.rows());
  for (long step = rows.lowest; step <= rows.highest; ++step) {
    add(material_index, largest * std::exp(static_cast<double>(step) * rows.step), 0);
  }
  return rows;
}

std::int32_t LawTableBuilder::add(std::size_t material_index, double peak, double pore_pressure) {
  const Material& m = *materials_[material_index];
  SofteningCurve curve = perfectly_plastic(peak);
  if (m.softening) curve = softening_curve(*m.softening, peak, cell_m_);
  LawTable& t = table_;
  if (m.softening && m.softening->band_m > 0) {
    t.band_m = m.softening->band_m;
    t.rate_share = cell_m_ / t.band_m;
  }
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
  t.tension.push_back(tension_of(m, peak));
  t.sin_friction.push_back(m.drains ? std::sin(radians(m.drained->friction_angle_deg)) : 0);
  t.pore_pressure.push_back(m.drains ? pore_pressure : 0);
  t.softens.push_back(m.softening ? 1 : 0);
  t.material.push_back(static_cast<std::int32_t>(material_index));
  if (viscous_) add_viscous(m, peak);
  t.stiffest_speed = std::max(t.stiffest_speed, p_wave_speed(m));
  return static_cast<std::int32_t>(t.rows() - 1);
}

void LawTableBuilder::add_viscous(const Material& m, double peak) {
  ViscousLaws& v = table_.viscous;
  leda::solver::add(rate_row(m.rate), v.rate);
  leda::solver::add(rate_row(m.remolded_rate), v.remolded_rate);
  v.remolded.push_back(std::min(m.remolded_strength_Pa(), peak));
  HerschelBulkleyFlow flow;
  if (m.flow) {
    const auto* bingham = std::get_if<BinghamFlow>(&*m.flow);
    flow = bingham ? HerschelBulkleyFlow{bingham->viscosity_Pa_s, 1}
                   : std::get<HerschelBulkleyFlow>(*m.flow);
  }
  v.consistency.push_back(flow.consistency_Pa_sn);
  v.flow_exponent.push_back(flow.exponent);
}

bool nearly_incompressible(const LawTable& table) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.bulk[row] > locking_ratio * table.shear[row]) return true;
  }
  return false;
}

bool RateColumns::depends() const {
  const auto is_some = [](double share) { return share != 0; };
  return std::ranges::any_of(log_share, is_some) || std::ranges::any_of(power_share, is_some);
}

bool has_rate(const LawTable& table) {
  return table.viscous.rate.depends() || table.viscous.remolded_rate.depends();
}

LawTable without_rate(const LawTable& table) {
  LawTable result = table;
  for (RateColumns* rate : {&result.viscous.rate, &result.viscous.remolded_rate}) {
    std::ranges::fill(rate->base, 1.0);
    std::ranges::fill(rate->log_share, 0.0);
    std::ranges::fill(rate->power_share, 0.0);
  }
  return result;
}

LawTable without_softening(const LawTable& table, bool elastic) {
  LawTable result = table;
  std::fill(result.softens.begin(), result.softens.end(), 0);
  if (elastic) std::fill(result.peak.begin(), result.peak.end(), beyond_reach);
  result.viscous = {};
  std::ranges::fill(result.tension, beyond_reach);
  if (elastic) std::ranges::fill(result.sin_friction, 0);
  result.band_m = 0;
  result.floor = result.peak;
  std::fill(result.amplitude.begin(), result.amplitude.end(), 0.0);
  std::fill(result.exp_end.begin(), result.exp_end.end(), endless);
  std::fill(result.line_end.begin(), result.line_end.end(), endless);
  return result;
}

}  // namespace leda::solver
