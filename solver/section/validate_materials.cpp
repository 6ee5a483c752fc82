// Faults of materials: thesis 4.5 (moduli, K0), 2.6 (strength over depth), eqs 4-2 to 4-4.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/section/fault_list.hpp"
#include "solver/section/possible_materials.hpp"
#include "solver/section/validate_field.hpp"

namespace leda {
namespace {

constexpr double kilo = 1000;  // Pa in a kPa, N in a kN

void check_strength_table(const Strength& strength, const std::string& at, FaultList& faults) {
  const bool depth = strength.by == Strength::By::depth;
  const std::string table = at + (depth ? "/at_depth_m" : "/at_elevation_m");
  if (strength.table.empty()) faults.add(table, "has no rows, needs at least one [m, kPa]");
  for (std::size_t i = 0; i < strength.table.size(); ++i) {
    const auto& [where, value] = strength.table[i];
    const std::string row = table + "/" + std::to_string(i);
    faults.positive(row + "/1", value / kilo, "kPa");
    if (!faults.within(row + "/0", where, !depth || where >= 0, "a depth of at least 0 m"))
      continue;
    if (i > 0 && where <= strength.table[i - 1][0]) {
      faults.add(row + "/0", "is " + show(where) + " m, must be greater than the row before it (" +
                                 show(strength.table[i - 1][0]) + " m)");
    }
  }
}

void check_strength(const Strength& strength, const std::string& at, FaultList& faults) {
  if (strength.by == Strength::By::constant) {
    faults.positive(at, strength.constant_Pa / kilo, "kPa");
  } else {
    check_strength_table(strength, at, faults);
  }
}

/// The smallest peak strength in kPa, or infinity where it is itself at fault: comparing with it
/// would only repeat that fault.
double sound_peak_kPa(const Strength& peak) {
  if (peak.by != Strength::By::constant && peak.table.empty()) return INFINITY;
  const double smallest = peak.smallest() / kilo;
  return smallest > 0 ? smallest : INFINITY;
}

/// Strains are fractions. The laboratory has residual strains of 0.95 to 2.5 (thesis Tables 3-3,
/// 3-4, 4-1) and remolded ones of 2.5 to 28; what lies this far beyond is a percentage.
constexpr double most_residual_strain = 20;
constexpr double most_remolded_strain = 200;

/// One softening law of a material whose smallest peak strength is `peak` kPa.
struct LawCheck {
  std::string at;
  double peak;
  FaultList& faults;

  bool strength_below_peak(const std::string& key, double pascal) const {
    const double value = pascal / kilo;
    if (!faults.positive(at + key, value, "kPa")) return false;
    if (value <= peak) return true;
    faults.add(at + key, "is " + show(value) + " kPa, must be at most the peak strength (" +
                             show(peak) + " kPa where it is smallest)");
    return false;
  }

  bool fraction(const std::string& key, double strain, double most) const {
    return faults.within(
        at + key, strain, strain > 0 && strain <= most,
        "greater than 0 and at most " + show(most) + ": strains are fractions (1.8, not 180 %)");
  }

  void operator()(const UrmiSoftening& law) const {
    faults.positive(at + "/alpha", law.alpha, "");
    faults.positive(at + "/beta", law.beta, "per unit strain");
    const bool strain = fraction("/residual_strain", law.residual_strain, most_residual_strain);
    if (law.residual_strength_Pa) {
      strength_below_peak("/residual_strength_kPa", *law.residual_strength_Pa);
    }
    if (strength_below_peak("/remolded_strength_kPa", law.remolded_strength_Pa)) {
      check_remolded_below_residual(law);
    }
    check_remolded_strain(law, strain);
  }

  void check_remolded_below_residual(const UrmiSoftening& law) const {
    const double remolded = law.remolded_strength_Pa / kilo;
    const double residual =
        law.residual_strength_Pa ? *law.residual_strength_Pa / kilo : 0.095 * peak;
    if (!(remolded > residual)) return;
    faults.add(at + "/remolded_strength_kPa",
               "is " + show(remolded) + " kPa, must be at most the residual strength (" +
                   show(residual) + " kPa" +
                   (law.residual_strength_Pa
                        ? ")"
                        : ": 0.095 of the smallest peak strength, as residual_strength_kPa is "
                          "not given)"));
  }

  void check_remolded_strain(const UrmiSoftening& law, bool residual_strain_is_sound) const {
    if (law.remolded_strain) {
      const std::string key = at + "/remolded_strain";
      if (!fraction("/remolded_strain", *law.remolded_strain, most_remolded_strain) ||
          !residual_strain_is_sound) {
        return;
      }
      if (*law.remolded_strain >= law.residual_strain) return;
      faults.add(key, "is " + show(*law.remolded_strain) + ", must be at least residual_strain (" +
                          show(law.residual_strain) + ")");
    } else if (0.13 * peak < 1) {
      faults.add(at + "/remolded_strain",
                 "must be given: the default, 0.13 of the peak strength in kPa times "
                 "residual_strain, is less than residual_strain for a peak strength of " +
                     show(peak) + " kPa");
    }
  }

  void operator()(const EinavRandolphSoftening& law) const {
    strength_below_peak("/remolded_strength_kPa", law.remolded_strength_Pa);
    fraction("/strain_95", law.strain_95, most_remolded_strain);
  }

  void operator()(const ExponentialSoftening& law) const {
    strength_below_peak("/remolded_strength_kPa", law.remolded_strength_Pa);
    faults.positive(at + "/shape_factor", law.shape_factor, "per unit strain");
  }

  void operator()(const LinearSoftening& law) const {
    strength_below_peak("/remolded_strength_kPa", law.remolded_strength_Pa);
    fraction("/remolded_strain", law.remolded_strain, most_remolded_strain);
  }

  void operator()(const DeySoftening& law) const {
    const double remolded = law.remolded_strength_Pa / kilo;
    const double large = law.large_strain_strength_Pa / kilo;
    const bool strengths =
        strength_below_peak("/remolded_strength_kPa", law.remolded_strength_Pa) &&
        strength_below_peak("/large_strain_strength_kPa", law.large_strain_strength_Pa);
    if (strengths && large > remolded) {
      faults.add(at + "/large_strain_strength_kPa",
                 "is " + show(large) + " kPa, must be at most remolded_strength_kPa (" +
                     show(remolded) + " kPa)");
    }
    const bool strain = fraction("/strain_95", law.strain_95, most_remolded_strain);
    if (faults.positive(at + "/large_strain", law.large_strain, "") && strain &&
        law.large_strain < 2 * law.strain_95) {
      faults.add(at + "/large_strain", "is " + show(law.large_strain) +
                                           ", must be at least twice strain_95 (" +
                                           show(2 * law.strain_95) + ")");
    }
  }
};

/// The bounds are those of the laws' sources, widened to what still makes sense.
struct RateCheck {
  std::string at;
  FaultList& faults;

  void reference(double rate) const { faults.positive(at + "/reference_rate_per_s", rate, "1/s"); }
  void share(const std::string& key, double value, const std::string& source) const {
    faults.within(at + key, value, value > 0 && value <= 1,
                  "greater than 0 and at most 1 (" + source + ")");
  }
  void operator()(const SemiLogarithmicRate& law) const {
    share("/per_decade", law.per_decade, "usually 0.05 to 0.2");
    reference(law.reference_rate);
  }
  void operator()(const PowerRate& law) const {
    share("/exponent", law.exponent, "usually 0.05 to 0.1");
    reference(law.reference_rate);
  }
  void operator()(const AdditivePowerRate& law) const {
    faults.positive(at + "/viscosity", law.viscosity, "");
    share("/exponent", law.exponent, "usually 0.4 to 0.6");
    reference(law.reference_rate);
  }
};

struct FlowCheck {
  std::string at;
  FaultList& faults;

  void operator()(const BinghamFlow& law) const {
    faults.positive(at + "/viscosity_Pa_s", law.viscosity_Pa_s, "Pa s");
  }
  void operator()(const HerschelBulkleyFlow& law) const {
    faults.positive(at + "/consistency_Pa_sn", law.consistency_Pa_sn, "Pa s^n");
    faults.within(at + "/exponent", law.exponent, law.exponent >= 0.1 && law.exponent <= 3,
                  "0.1 to 3");
  }
};

/// Mohr and Coulomb's surface ends at c' / tan(phi').
void check_drained_tension(const Material& m, const std::string& at, FaultList& faults) {
  const double value = *m.tensile_strength_Pa / kilo;
  if (!faults.within(at, value, value >= 0, "at least 0 kPa") || !m.drained) return;
  const double angle = m.drained->friction_angle_deg * std::numbers::pi / 180;
  const double most = m.drained->cohesion_Pa / kilo / std::tan(angle);
  if (!(value > most)) return;
  faults.add(at, "is " + show(value) + " kPa, must be at most " + show(most) +
                     " kPa, its cohesion over the tangent of its friction angle");
}

/// Ground that drains has the strength of `drained` and no other.
void check_drainage(const Material& m, const std::string& at, FaultList& faults) {
  if (!m.drained) {
    faults.add(at + "/drainage",
               "is \"drained\" without the strength: give drained with cohesion_kPa and "
               "friction_angle_deg");
  } else if (!(m.drained->friction_angle_deg > 0)) {
    faults.add(at + "/drained/friction_angle_deg",
               "is " + show(m.drained->friction_angle_deg) +
                   " degrees, must be greater than 0 where drainage is \"drained\"");
  }
  const auto refuse = [&](bool given, const char* key) {
    if (given) faults.add(at + key, "is given for ground that drains: it is of undrained clay");
  };
  refuse(m.softening.has_value(), "/softening");
  refuse(m.rate || m.remolded_rate, "/rate");
  refuse(m.flow.has_value(), "/flow");
}

/// Under uniaxial tension Tresca's surface ends at 2 s_up: a higher cut-off would never be reached.
void check_tension(const Material& m, const std::string& at, FaultList& faults) {
  if (m.drains) return check_drained_tension(m, at, faults);
  const double value = *m.tensile_strength_Pa / kilo, most = 2 * sound_peak_kPa(m.peak_strength);
  if (!faults.within(at, value, value >= 0, "at least 0 kPa") || value <= most) return;
  faults.add(at, "is " + show(value) + " kPa, must be at most twice the peak strength (" +
                     show(most) + " kPa where it is smallest), where shear yields first");
}

void check_material(const Material& m, const std::string& at, FaultList& faults) {
  const double unit_weight = m.unit_weight / kilo;
  // The bounds catch t/m3 (1.3 to 2.7) and N/m3 given for kN/m3.
  faults.within(at + "/unit_weight_kN_m3", unit_weight, unit_weight > 3 && unit_weight <= 50,
                "greater than 3 and at most 50 kN/m3: the total weight, water included");
  faults.positive(at + "/shear_modulus_kPa", m.shear_modulus_Pa / kilo, "kPa");
  faults.within(at + "/poisson_ratio", m.poisson_ratio,
                m.poisson_ratio >= 0 && m.poisson_ratio < 0.5, "at least 0 and below 0.5");
  check_strength(m.peak_strength, at + "/peak_strength_kPa", faults);
  check_possible(m, at, faults);
  if (m.drained) {
    const double cohesion = m.drained->cohesion_Pa / kilo;
    faults.within(at + "/drained/cohesion_kPa", cohesion, cohesion >= 0, "at least 0 kPa");
  }
  if (m.softening) {
    const std::string softening = at + "/softening";
    std::visit(LawCheck{softening, sound_peak_kPa(m.peak_strength), faults}, m.softening->law);
    const double size = m.softening->reference_size_m;
    faults.within(softening + "/reference_size_m", size, size > 0 && size <= 1,
                  "greater than 0 and at most 1 m: the height of the specimen");
    if (m.softening->regularization == Regularization::band) {
      faults.positive(softening + "/band_m", m.softening->band_m, "m");
    }
  }
  if (m.rate) std::visit(RateCheck{at + "/rate", faults}, *m.rate);
  if (m.remolded_rate) {
    std::visit(RateCheck{at + "/rate/remolded", faults}, *m.remolded_rate);
    if (!m.softening) {
      faults.add(at + "/rate/remolded",
                 "is given for ground that does not soften: it has no remolded strength");
    }
  }
  if (m.drains) check_drainage(m, at, faults);
  if (m.tensile_strength_Pa) check_tension(m, at + "/tensile_strength_kPa", faults);
  if (m.flow) std::visit(FlowCheck{at + "/flow", faults}, *m.flow);
  if (m.field) check_field(m, at, faults);
}

/// Strain is averaged over one band in all of the ground: all that softens has to name the same.
void check_bands(const std::map<std::string, Material>& materials, const std::string& at,
                 FaultList& faults) {
  const auto with_band = std::ranges::find_if(materials, [](const auto& entry) {
    const auto& softening = entry.second.softening;
    return softening && softening->regularization == Regularization::band;
  });
  if (with_band == materials.end()) return;
  const double band = with_band->second.softening->band_m;
  for (const auto& [name, m] : materials) {
    if (!m.softening) continue;
    const std::string softening = at + "/" + pointer_part(name) + "/softening";
    if (m.softening->regularization != Regularization::band) {
      faults.add(softening + "/regularization",
                 "must be band, as of " + with_band->first + ": all materials that soften or none");
    } else if (m.softening->band_m != band) {
      faults.add(softening + "/band_m", "is " + show(m.softening->band_m) + " m, must be " +
                                            show(band) + " m as of " + with_band->first +
                                            ": a section has one thickness of bands");
    }
  }
}

}  // namespace

std::vector<Fault> validate_materials(const std::map<std::string, Material>& materials,
                                      const std::string& at) {
  FaultList faults;
  if (materials.empty()) faults.add(at, "is empty, needs at least one material");
  for (const auto& [name, material] : materials) {
    check_material(material, at + "/" + pointer_part(name), faults);
  }
  check_bands(materials, at, faults);
  return faults.take();
}

}  // namespace leda
