#include "solver/screening/slope_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace leda::solver {
namespace {

Stratum resolve(const Section& section, const Layer& layer, bool is_last, bool drained) {
  const Material& material = section.materials.at(layer.material);
  Stratum s;
  if (layer.thickness_m) {
    s.kind = Stratum::Bottom::thickness;
    s.value = *layer.thickness_m;
  } else if (!layer.bottom.empty()) {
    s.kind = Stratum::Bottom::line;
    s.line = layer.bottom;
  } else {
    // Elevations, and depths below the toe, are the same at every x.
    s.value = section.base_m;
    if (layer.bottom_m) s.value = *layer.bottom_m;
    if (layer.bottom_below_toe_m) {
      const double highest = std::ranges::max(section.ground, {}, &Point::z).z;
      const auto top = std::ranges::find(section.ground, highest, &Point::z);
      s.value = layer_bottom(section, layer, top->x);
    }
    if (is_last) s.value = section.base_m;
  }
  s.unit_weight = material.unit_weight;
  s.undrained = &material.peak_strength;
  s.drains = drained || material.drains;
  if (s.drains && material.drained) {
    s.cohesion = material.drained->cohesion_Pa;
    s.tan_phi = std::tan(material.drained->friction_angle_deg * std::numbers::pi / 180);
  }
  return s;
}

}  // namespace

SlopeModel::SlopeModel(const Section& section, Polyline present, Drainage drainage)
    : ground(std::move(present)), reference(section.ground), base(section.base_m) {
  const bool drained = drainage == Drainage::drained;
  for (std::size_t list = 0; list < layer_lists(section); ++list) {
    const std::vector<Layer>& layers = layers_of(section, list);
    StrataFrom column;
    if (!section.columns.empty()) column.from = section.columns[list].from_m;
    for (const Layer& layer : layers) {
      column.strata.push_back(resolve(section, layer, &layer == &layers.back(), drained));
      drains = drains || column.strata.back().drains;
    }
    most_strata = std::max(most_strata, layers.size());
    if (list > 0) steps.push_back(column.from);
    columns.push_back(std::move(column));
  }
  if (section.water_table) {
    wet = true;
    water_follows_ground = section.water_table->depth_m.has_value();
    water_depth = section.water_table->depth_m.value_or(0);
    water = section.water_table->line;
  }
  for (std::size_t i = 1; i < ground.size(); ++i) {
    if (ground[i].x == ground[i - 1].x && ground[i].z != ground[i - 1].z) {
      steps.push_back(ground[i].x);
    }
  }
}

Column::Column(const SlopeModel& model)
    : model_(&model), present_(model.ground), own_(model.reference), water_(model.water) {
  enter(0);
}

void Column::enter(std::size_t column) {
  column_ = column;
  lines_.clear();
  for (const Stratum& s : model_->columns[column].strata) lines_.emplace_back(s.line);
  bottoms_.resize(lines_.size());
}

void Column::move_to(double x) {
  std::size_t column = column_;
  while (column + 1 < model_->columns.size() && x >= model_->columns[column + 1].from) ++column;
  if (column != column_) enter(column);
  ground_ = present_.at(x);
  own_ground_ = own_.at(x);
  const double highest = std::max(own_ground_, model_->base);
  for (std::size_t i = 0; i < bottoms_.size(); ++i) {
    const Stratum& s = model_->columns[column_].strata[i];
    double z = s.value;
    if (s.kind == Stratum::Bottom::thickness) z = own_ground_ - s.value;
    if (s.kind == Stratum::Bottom::line) z = lines_[i].at(x);
    bottoms_[i] = std::clamp(z, model_->base, highest);
  }
  bottoms_.back() = model_->base;
  if (model_->wet && model_->drains) {
    water_level_ = model_->water_follows_ground ? own_ground_ - model_->water_depth : water_.at(x);
  }
}

double Column::weight_above(double z) const {
  double weight = 0;
  double top = ground_;
  for (std::size_t i = 0; i < bottoms_.size() && top > z; ++i) {
    const double bottom = std::max(bottoms_[i], z);
    if (bottom >= top) continue;
    weight += model_->columns[column_].strata[i].unit_weight * (top - bottom);
    top = bottom;
  }
  return weight;
}

std::size_t Column::stratum_at(double z) const {
  for (std::size_t i = 0; i + 1 < bottoms_.size(); ++i) {
    if (z >= bottoms_[i]) return i;
  }
  return bottoms_.size() - 1;
}

Resistance Column::resistance_in(std::size_t index, double z) const {
  const Stratum& s = model_->columns[column_].strata[index];
  if (!s.drains) {
    const bool constant = s.undrained->by == Strength::By::constant;
    return {constant ? s.undrained->constant_Pa : s.undrained->at(own_ground_ - z, z), 0, 0};
  }
  const double head = model_->wet ? std::max(0.0, water_level_ - z) : 0;
  return {s.cohesion, s.tan_phi, head * water_unit_weight};
}

Resistance Column::resistance_at(double z) const { return resistance_in(stratum_at(z), z); }

Resistance Column::resistance_on(std::size_t stratum) const {
  const std::size_t index = std::min(stratum, last());
  const double z = bottoms_[index];
  const Resistance above = resistance_in(index, z);
  if (index + 1 == bottoms_.size()) return above;
  const Resistance below = resistance_in(index + 1, z);
  const double load = std::max(0.0, weight_above(z) - above.pore_pressure);
  const bool above_is_weaker =
      above.cohesion + load * above.tan_phi <= below.cohesion + load * below.tan_phi;
  return above_is_weaker ? above : below;
}

}  // namespace leda::solver
