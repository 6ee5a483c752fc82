#include "solver/section/possible_materials.hpp"

#include <cmath>
#include <numbers>

namespace leda {
namespace {

constexpr double kilo = 1000;  // Pa in a kPa

/// Passive earth pressure bounds the ratio of effective stresses (Rankine): without cohesion it
/// cannot be passed, with some only where the ground is shallow.
void check_k0(const Material& m, const std::string& at, FaultList& faults) {
  if (!faults.within(at + "/k0", m.k0, m.k0 > 0 && m.k0 <= 10, "greater than 0 and at most 10")) {
    return;
  }
  if (!m.drained || !(m.drained->cohesion_Pa >= 0)) return;
  const double angle = m.drained->friction_angle_deg;
  if (!(angle >= 0 && angle < 90)) return;
  const double root = std::tan((45 + angle / 2) * std::numbers::pi / 180);
  const double passive = root * root;
  const double most = m.drained->cohesion_Pa > 0 ? 2 * passive : passive;
  if (m.k0 <= most * (1 + 1e-9)) return;
  faults.add(at + "/k0", "is " + show(m.k0) + ", must be at most " + show(most) +
                             ": the passive ratio of its drained strength is " + show(passive));
}

/// Degrees, not radians: no soil has less than 3 degrees, and 3 radians are no angle of friction.
void check_friction_angle(double angle, const std::string& at, FaultList& faults) {
  const std::string key = at + "/drained/friction_angle_deg";
  if (!faults.within(key, angle, angle >= 0 && angle < 90, "at least 0 and below 90 degrees")) {
    return;
  }
  if (angle > 0 && angle < 3) {
    faults.add(key, "is " + show(angle) + ", must be 0 or at least 3 degrees; in radians it is " +
                        show(std::round(angle * 180 / std::numbers::pi * 10) / 10) + " degrees");
  }
}

/// Pa for kPa, MPa for kPa. Sensitive clays have up to 320 kPa (thesis Table 3-1); ground softer
/// than its strength would strain by more than the whole before it yields.
void check_magnitudes(const Material& m, const std::string& at, FaultList& faults) {
  constexpr double most_softening_kPa = 1000, stiffest_softening = 20'000;
  const std::string key = at + "/peak_strength_kPa";
  if (m.peak_strength.by != Strength::By::constant && m.peak_strength.table.empty()) return;
  const double largest = m.peak_strength.largest() / kilo;
  const double smallest = m.peak_strength.smallest() / kilo;
  const double modulus = m.shear_modulus_Pa / kilo;
  if (m.softening && largest > most_softening_kPa) {
    faults.add(key, "is " + show(largest) + " kPa, must be at most " + show(most_softening_kPa) +
                        " kPa in clay that softens; is it in Pa?");
  } else if (m.softening && largest > 0 && modulus > stiffest_softening * largest) {
    faults.add(key, "is " + show(largest) + " kPa beside a shear modulus of " + show(modulus) +
                        " kPa, which must be at most " + show(stiffest_softening) +
                        " times as much in clay that softens (47 to 123 are known); is one of " +
                        "them in another unit?");
  } else if (modulus > 0 && smallest > 0 && modulus < smallest) {
    faults.add(key, "is " + show(smallest) + " kPa, must be at most the shear modulus, " +
                        show(modulus) + " kPa; is one of them in another unit?");
  }
}

/// The most liquid clays measured have 0.005 kPa (Locat and Demers 1988, liquidity index of 5; the
/// thesis's sites 0.07 to 3); with a fifth of it a number is in MPa.
void check_remolded(const Softening& softening, const std::string& at, FaultList& faults) {
  constexpr double least_kPa = 0.001;
  const auto check = [&](const char* key, double pascal) {
    const double value = pascal / kilo;
    if (!(value > 0) || value >= least_kPa) return;
    faults.add(at + key, "is " + show(value) + " kPa, must be at least " + show(least_kPa) +
                             " kPa: the most liquid clays have 0.005; is it in MPa?");
  };
  const auto remolded = [](const auto& law) { return law.remolded_strength_Pa; };
  check("/remolded_strength_kPa", std::visit(remolded, softening.law));
  if (const auto* dey = std::get_if<DeySoftening>(&softening.law)) {
    check("/large_strain_strength_kPa", dey->large_strain_strength_Pa);
  }
}

/// Rates of tests: 1e-7 1/s and less in creep, about 1 1/s and more under a fall cone.
void check_reference_rate(const RateLaw& law, const std::string& at, FaultList& faults) {
  constexpr double least = 1e-12, most = 1000;
  const double rate = std::visit([](const auto& one) { return one.reference_rate; }, law);
  if (!(rate > 0) || (rate >= least && rate <= most)) return;
  faults.add(at + "/reference_rate_per_s", "is " + show(rate) + " 1/s, must be " + show(least) +
                                               " to " + show(most) +
                                               " 1/s: no test shears like that");
}

/// What a flow law adds at a rate of 1 1/s. Water has 0.001 Pa s; ground with 1e6 Pa s would be
/// held by it at a rate at which no slide is seen to move.
void check_flow(const FlowLaw& law, const std::string& at, FaultList& faults) {
  constexpr double least = 0.001, most = 1e6;
  const auto check = [&](const char* key, double value, const char* unit) {
    if (!(value > 0) || (value >= least && value <= most)) return;
    faults.add(at + key, "is " + show(value) + " " + unit + ", must be " + show(least) +
                             " (water) to " + show(most) + " " + unit);
  };
  if (const auto* bingham = std::get_if<BinghamFlow>(&law)) {
    check("/viscosity_Pa_s", bingham->viscosity_Pa_s, "Pa s");
  } else {
    check("/consistency_Pa_sn", std::get<HerschelBulkleyFlow>(law).consistency_Pa_sn, "Pa s^n");
  }
}

}  // namespace

void check_possible(const Material& m, const std::string& at, FaultList& faults) {
  check_k0(m, at, faults);
  if (m.drained) check_friction_angle(m.drained->friction_angle_deg, at, faults);
  check_magnitudes(m, at, faults);
  if (m.softening) check_remolded(*m.softening, at + "/softening", faults);
  if (m.rate) check_reference_rate(*m.rate, at + "/rate", faults);
  if (m.remolded_rate) check_reference_rate(*m.remolded_rate, at + "/rate/remolded", faults);
  if (m.flow) check_flow(*m.flow, at + "/flow", faults);
}

}  // namespace leda
