// Magnitudes that few soils have. The ranges are those of the sites of the thesis (Tables 3-1 to
// 3-6, 4-1, 5-2 and its appendices), widened to what other soils and rock reach; outside of them a
// number is more often a mistake of units than ground.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/section/fault_list.hpp"
#include "solver/section/warnings.hpp"

namespace leda {
namespace {

constexpr double kilo = 1000;  // Pa in a kPa, N in a kN

double tan2(double angle_deg) {
  const double t = std::tan(angle_deg * std::numbers::pi / 180);
  return t * t;
}

struct Oddities {
  const std::string& name;
  std::vector<std::string>& warnings;

  void add(const char* key, double value, const std::string& what) const {
    warnings.push_back("material " + name + ": " + key + " is " + show(value) + ": " + what);
  }
  void outside(const char* key, double value, double least, double most,
               const std::string& what) const {
    if (value < least || value > most) add(key, value, what);
  }
};

void look_at_strength(const Material& m, const Oddities& odd) {
  const double smallest = m.peak_strength.smallest() / kilo;
  const double largest = m.peak_strength.largest() / kilo;
  if (largest > 1000) {
    odd.add("peak_strength_kPa", largest,
            "above 1000 kPa is rock, no clay; is it Pa given for kPa?");
  }
  if (smallest < 1) {
    odd.add("peak_strength_kPa", smallest, "below 1 kPa is a liquid; is it MPa given for kPa?");
  }
  // Thesis Tables 4-5 and 5-2: 47 to 123.
  const double G = m.shear_modulus_Pa / kilo;
  if (G < 20 * largest) {
    odd.add("shear_modulus_kPa", G,
            "less than 20 times the peak strength (" + show(largest) +
                " kPa) is softer than clays are; is it MPa given for kPa?");
  }
  if (G > 2000 * smallest) {
    odd.add("shear_modulus_kPa", G,
            "more than 2000 times the peak strength (" + show(smallest) +
                " kPa) is stiffer than clays are; is it Pa given for kPa?");
  }
}

void look_at_drained(const Material& m, const Oddities& odd) {
  const DrainedStrength& drained = *m.drained;
  odd.outside("drained/friction_angle_deg", drained.friction_angle_deg, 15, 50,
              "soils have 15 to 50 degrees");
  odd.outside("drained/cohesion_kPa", drained.cohesion_Pa / kilo, 0, 100,
              "soils have less than 100 kPa");
  const double active = tan2(45 - drained.friction_angle_deg / 2);
  const double passive = tan2(45 + drained.friction_angle_deg / 2);
  if (m.k0 > passive) {
    odd.add("k0", m.k0,
            "more than the passive ratio of its drained strength (" +
                show(std::round(passive * 100) / 100) + "), held by cohesion alone");
  } else if (m.k0 < active) {
    odd.add("k0", m.k0,
            "less than the active ratio of its drained strength (" +
                show(std::round(active * 100) / 100) + "), held by cohesion alone");
  }
}

struct OddLaw {
  const Oddities& odd;

  void operator()(const UrmiSoftening& law) const {
    remolded_strength(law.remolded_strength_Pa);
    odd.outside("softening/alpha", law.alpha, 0.5, 3, "the laboratory gives 0.9 to 1.6");
    odd.outside("softening/beta", law.beta, 0.3, 1000,
                "the laboratory gives 2 to 6 per unit strain, not per percent");
    odd.outside("softening/residual_strain", law.residual_strain, 0.2, 5,
                "the laboratory gives 0.9 to 2.5, as a fraction");
    if (law.remolded_strain) remolded_strain(*law.remolded_strain);
  }
  void operator()(const EinavRandolphSoftening& law) const {
    remolded_strength(law.remolded_strength_Pa);
    odd.outside("softening/strain_95", law.strain_95, 0.01, 50,
                "10 to 50 and less is known, as a fraction");
  }
  void operator()(const ExponentialSoftening& law) const {
    remolded_strength(law.remolded_strength_Pa);
    odd.outside("softening/shape_factor", law.shape_factor, 0.3, 1000,
                "20 to 90 per unit strain is known, not per percent");
  }
  void operator()(const LinearSoftening& law) const {
    remolded_strength(law.remolded_strength_Pa);
    remolded_strain(law.remolded_strain);
  }
  void operator()(const DeySoftening& law) const {
    remolded_strength(law.large_strain_strength_Pa, "softening/large_strain_strength_kPa");
    odd.outside("softening/strain_95", law.strain_95, 0.01, 50,
                "10 to 50 and less is known, as a fraction");
  }
  /// Thesis Tables 3-1 and 3-3: 0.07 to 3 kPa.
  void remolded_strength(double pascal, const char* key = "softening/remolded_strength_kPa") const {
    odd.outside(key, pascal / kilo, 0.05, 20,
                "sensitive clays have 0.07 to 3 kPa; is it in another unit?");
  }
  void remolded_strain(double strain) const {
    odd.outside("softening/remolded_strain", strain, 0, 100,
                "the laboratory gives 2 to 30, as a fraction");
  }
};

/// What the strength above the remolded one was measured at: 1.4e-5 1/s in direct simple shear,
/// 1e-3 to 1e-2 under a field vane; laws of the additive power have about 1 (Shan 2021).
void look_at_rate(const RateLaw& law, const Oddities& odd) {
  const double most = std::holds_alternative<AdditivePowerRate>(law) ? 2 : 0.1;
  const double rate = std::visit([](const auto& one) { return one.reference_rate; }, law);
  odd.outside("rate/reference_rate_per_s", rate, 1e-8, most,
              "direct simple shear has 1.4e-5 1/s (5 %/h) and the field vane 0.001 to 0.01; is it "
              "in %/h or 1/h?");
}

/// The remolded strength is measured fast: by vane, or by fall cone at about 1 1/s and more.
void look_at_remolded_rate(const RateLaw& law, const Oddities& odd) {
  const double rate = std::visit([](const auto& one) { return one.reference_rate; }, law);
  odd.outside("rate/remolded/reference_rate_per_s", rate, 1e-6, 100,
              "the vane has 0.001 to 0.01 1/s and the fall cone about 1");
}

/// Remolded clays have 0.007 to 0.2 Pa s in the laboratory (Locat and Demers 1988); slides were
/// fitted with 100 to 500.
void look_at_flow(const FlowLaw& law, const Oddities& odd) {
  if (const auto* bingham = std::get_if<BinghamFlow>(&law)) {
    odd.outside("flow/viscosity_Pa_s", bingham->viscosity_Pa_s, 0.005, 2000,
                "remolded clays have 0.007 to 0.2 Pa s, and slides were fitted with 100 to 500");
  } else {
    odd.outside("flow/consistency_Pa_sn", std::get<HerschelBulkleyFlow>(law).consistency_Pa_sn,
                0.005, 5000, "remolded clays flow with less, and slides were fitted with less");
  }
}

void look_at(const Material& m, const Oddities& odd) {
  odd.outside("unit_weight_kN_m3", m.unit_weight / kilo, 12, 27,
              "soils have 12 to 23 and rock up to 27 kN/m3, water included");
  look_at_strength(m, odd);
  if (m.drained) {
    look_at_drained(m, odd);
  } else if (m.k0 > 3) {
    odd.add("k0", m.k0, "the most overconsolidated clays have about 3");
  }
  if (m.rate) look_at_rate(*m.rate, odd);
  if (m.remolded_rate) look_at_remolded_rate(*m.remolded_rate, odd);
  if (m.flow) look_at_flow(*m.flow, odd);
  if (!m.softening) return;
  std::visit(OddLaw{odd}, m.softening->law);
  odd.outside("softening/reference_size_m", m.softening->reference_size_m, 0.005, 0.3,
              "specimens are 0.01 to 0.1 m high");
}

}  // namespace

std::vector<std::string> warnings_of(const std::map<std::string, Material>& materials) {
  std::vector<std::string> warnings;
  for (const auto& [name, material] : materials) look_at(material, {name, warnings});
  return warnings;
}

}  // namespace leda
