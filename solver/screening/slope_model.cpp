#include "solver/screening/slope_model.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace leda::solver {
namespace {

Stratum resolve(const Section& section, std::size_t index, bool drained) {
  const Layer& layer = section.layers[index];
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
    s.value = layer_bottom(section, index, 0);
    if (layer.bottom_m) s.value = *layer.bottom_m;
    if (layer.bottom_below_toe_m) {
      const double highest = std::ranges::max(section.ground, {}, &Point::z).z;
      const auto top = std::ranges::find(section.ground, highest, &Point::z);
      s.value = layer_bottom(section, index, top->x);
    }
    if (index + 1 == section.layers.size()) s.value = section.base_m;
  }
  s.unit_weight = material.unit_weight;
  s.undrained = &material.peak_strength;
  if (drained && material.drained) {
    s.cohesion = material.drained->cohesion_Pa;
    s.tan_phi = std::tan(material.drained->friction_angle_deg * std::numbers::pi / 180);
  }
  return s;
}

}  // namespace

SlopeModel::SlopeModel(const Section& section, Polyline present, Drainage drainage)
    : ground(std::move(present)),
      reference(section.ground),
      base(section.base_m),
      drained(drainage == Drainage::drained) {
  for (std::size_t i = 0; i < section.layers.size(); ++i) {
    strata.push_back(resolve(section, i, drained));
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
    : model_(&model),
      present_(model.ground),
      own_(model.reference),
      water_(model.water),
      bottoms_(model.strata.size()) {
  for (const Stratum& s : model.strata) lines_.emplace_back(s.line);
}

void Column::move_to(double x) {
  ground_ = present_.at(x);
  own_ground_ = own_.at(x);
  const double highest = std::max(own_ground_, model_->base);
  for (std::size_t i = 0; i < bottoms_.size(); ++i) {
    const Stratum& s = model_->strata[i];
    double z = s.value;
    if (s.kind == Stratum::Bottom::thickness) z = own_ground_ - s.value;
    if (s.kind == Stratum::Bottom::line) z = lines_[i].at(x);
    bottoms_[i] = std::clamp(z, model_->base, highest);
  }
  bottoms_.back() = model_->base;
  if (model_->wet && model_->drained) {
    water_level_ = model_->water_follows_ground ? own_ground_ - model_->water_depth : water_.at(x);
  }
}

double Column::weight_above(double z) const {
  double weight = 0;
  double top = ground_;
  for (std::size_t i = 0; i < bottoms_.size() && top > z; ++i) {
    const double bottom = std::max(bottoms_[i], z);
    if (bottom >= top) continue;
    weight += model_->strata[i].unit_weight * (top - bottom);
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
  const Stratum& s = model_->strata[index];
  if (!model_->drained) {
    const bool constant = s.undrained->by == Strength::By::constant;
    return {constant ? s.undrained->constant_Pa : s.undrained->at(own_ground_ - z, z), 0, 0};
  }
  const double head = model_->wet ? std::max(0.0, water_level_ - z) : 0;
  return {s.cohesion, s.tan_phi, head * water_unit_weight};
}

Resistance Column::resistance_at(double z) const { return resistance_in(stratum_at(z), z); }

Resistance Column::resistance_on(std::size_t index) const {
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
