#include "tests/validation/generated_sections.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace leda::test {
namespace {

/// SplitMix64 (Steele, Lea and Flood 2014): the standard library's distributions differ between
/// machines.
class Draw {
 public:
  /// A mixed start: neighbouring seeds must not draw the same numbers one place apart.
  explicit Draw(std::uint64_t seed) : state_(mixed(seed + stride) ^ (seed << 32)) {}

  double between(double low, double high) { return low + (high - low) * unit(); }
  bool chance(double share) { return unit() < share; }

 private:
  static constexpr std::uint64_t stride = 0x9E3779B97F4A7C15ULL;

  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31);
  }

  double unit() { return static_cast<double>(mixed(state_ += stride) >> 11) * 0x1.0p-53; }

  std::uint64_t state_;
};

/// Softer clay than this has a remolded strain below its residual strain (eq. 3-13).
constexpr double softest_Pa = 10e3;

Material stiff(double unit_weight, double strength_Pa) {
  Material m;
  m.unit_weight = unit_weight;
  m.shear_modulus_Pa = 100 * strength_Pa;
  m.poisson_ratio = 0.45;
  m.peak_strength.constant_Pa = strength_Pa;
  return m;
}

/// Softening within the range of Tables 3-3 and 3-4.
Softening draw_softening(Draw& draw, double strength_Pa) {
  UrmiSoftening law;
  law.alpha = draw.between(0.94, 1.2);
  law.beta = draw.between(2.4, 6.0);
  law.residual_strain = draw.between(0.95, 2.5);
  law.remolded_strength_Pa = std::min(draw.between(200, 1600), 0.08 * strength_Pa);
  return {law, 0.014, Regularization::beta};
}

Strength draw_strength(Draw& draw, double at_mid_bank_Pa, double height) {
  Strength strength;
  strength.constant_Pa = at_mid_bank_Pa;
  if (draw.chance(0.5)) return strength;
  const double per_metre = draw.between(0.3e3, 2.0e3);
  strength.by = Strength::By::depth;
  strength.table = {
      {0, std::max({softest_Pa, 0.5 * at_mid_bank_Pa, at_mid_bank_Pa - per_metre * height / 2})},
      {height / 2, at_mid_bank_Pa},
      {4 * height, at_mid_bank_Pa + per_metre * 3.5 * height}};
  return strength;
}

Polyline draw_ground(Draw& draw, double height, double angle_deg) {
  const double run = height / std::tan(angle_deg * std::numbers::pi / 180);
  const double behind = 4 * height;
  const double crest_x = behind;
  const double toe_x = crest_x + run;
  Polyline ground{{0, height}, {crest_x, height}};
  if (draw.chance(0.3)) {  // a bench or a steeper foot
    ground.push_back({crest_x + 0.5 * run, height * draw.between(0.42, 0.62)});
  }
  ground.push_back({toe_x, 0});
  const double floor = draw.between(0.8, 2.5) * height;
  ground.push_back({toe_x + floor, 0});
  if (draw.chance(0.4)) {  // the other side of the brook, lower and gentler than the bank
    const double other = draw.between(0.3, 0.7) * height;
    ground.push_back({toe_x + floor + 2.5 * other, other});
    ground.push_back({toe_x + floor + 2.5 * other + 2 * height, other});
  } else {
    ground.push_back({toe_x + floor + height, 0});
  }
  return ground;
}

}  // namespace

GeneratedCase generate_case(std::uint64_t seed, double cells_per_height) {
  Draw draw(seed);
  GeneratedCase c;
  c.height_m = draw.between(4, 25);
  c.angle_deg = draw.between(12, 55);
  const double unit_weight = draw.between(15.5e3, 18.9e3);
  // Stability numbers m H / s_up from 2 to 9: from sound to far beyond failure.
  c.strength_Pa = std::max(softest_Pa, unit_weight * c.height_m / draw.between(2, 9));
  c.water_depth_m = draw.between(0, 3);

  Section& s = c.section;
  s.name = "generated-" + std::to_string(seed);
  s.ground = draw_ground(draw, c.height_m, c.angle_deg);
  s.base_m = -draw.between(0.15, 0.8) * c.height_m;
  if (!draw.chance(0.1)) s.water_table = WaterTable{c.water_depth_m, {}};
  Material clay = stiff(unit_weight, c.strength_Pa);
  clay.peak_strength = draw_strength(draw, c.strength_Pa, c.height_m);
  clay.k0 = draw.between(0.45, 0.7);
  if (!draw.chance(0.08)) clay.softening = draw_softening(draw, clay.peak_strength.smallest());
  s.materials["clay"] = clay;
  Layer whole;
  whole.material = "clay";
  s.layers = {whole};
  if (draw.chance(0.6)) {
    s.materials["crust"] = stiff(18e3, std::max(1.5 * c.strength_Pa, 60e3));
    Layer crust;
    crust.material = "crust";
    crust.thickness_m = draw.between(0.08, 0.2) * c.height_m;
    s.layers.insert(s.layers.begin(), crust);
  }

  UndrainedTrigger trigger;
  if (draw.chance(0.7)) {
    c.toe_cut_m = std::min(draw.between(1, 4), 0.4 * c.height_m);
    trigger.then_toe_cut_m = c.toe_cut_m;
  }
  c.settings.trigger = trigger;
  c.settings.resolution.cell_m = c.height_m / cells_per_height;
  c.settings.stop.max_time_s = 60;
  return c;
}

}  // namespace leda::test
