#include "solver/screening/criteria.hpp"

#include <charconv>
#include <iterator>

#include "solver/screening/remolding_energy.hpp"

namespace leda::solver {
namespace {

using Verdict = std::optional<bool>;

/// One comparison, said in words: "N_s = 7.1 > 4".
struct Test {
  Verdict holds;
  std::string said;
};

std::string number(double value) {
  char text[32];
  const auto end =
      std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, 4);
  return {std::begin(text), end.ptr};
}

Test above(const char* name, const std::optional<double>& value, double limit,
           const char* unit = "") {
  if (!value) return {{}, std::string(name) + " is not known (> " + number(limit) + unit + ")"};
  const bool holds = *value > limit;
  return {holds, std::string(name) + " = " + number(*value) + (holds ? " > " : " <= ") +
                     number(limit) + unit};
}

Test below(const char* name, const std::optional<double>& value, double limit,
           const char* unit = "") {
  if (!value) return {{}, std::string(name) + " is not known (< " + number(limit) + unit + ")"};
  const bool holds = *value < limit;
  return {holds, std::string(name) + " = " + number(*value) + (holds ? " < " : " >= ") +
                     number(limit) + unit};
}

/// Both; decided as soon as one fails.
Test both(const Test& a, const Test& b) {
  Verdict holds;
  if ((a.holds && !*a.holds) || (b.holds && !*b.holds))
    holds = false;
  else if (a.holds && b.holds)
    holds = true;
  return {holds, a.said + " and " + b.said};
}

/// Either; decided as soon as one holds.
Test either(const Test& a, const Test& b) {
  Verdict holds;
  if ((a.holds && *a.holds) || (b.holds && *b.holds))
    holds = true;
  else if (a.holds && b.holds)
    holds = false;
  return {holds, a.said + " or " + b.said};
}

Criterion criterion(const char* name, const Test& test) { return {name, test.holds, test.said}; }

std::optional<double> kilo(const std::optional<double>& value) {
  if (!value) return std::nullopt;
  return *value / 1000;
}

/// What it takes to remold the clay to 70 % against what the fall gives.
Test remolds_to_70_percent(const Site& site, const Analytics& known) {
  const auto curve = post_peak_curve(site);
  if (!curve || !known.potential_energy) {
    return {{}, "energy to I_r = 70 % is not known (w_L < 40 % would do too)"};
  }
  const double needed = energy_to_remolding_index(*curve, 0.7);
  const bool holds = *known.potential_energy > needed;
  return {holds, "E_P = " + number(*known.potential_energy / 1000) + (holds ? " > " : " <= ") +
                     number(needed / 1000) + " kJ/m3 to reach I_r = 70 %"};
}

Test more_energy_than_remolding(const Analytics& known) {
  if (!known.potential_energy || !known.remolding.complete_curve) {
    return {{}, "the remolding energy is not known"};
  }
  const bool holds = *known.potential_energy > *known.remolding.complete_curve;
  return {holds, "E_P = " + number(*known.potential_energy / 1000) + (holds ? " > " : " <= ") +
                     "E_R = " + number(*known.remolding.complete_curve / 1000) + " kJ/m3"};
}

}  // namespace

std::vector<Criterion> retrogression_criteria(const Site& site, const Analytics& known) {
  const auto& liquidity = site.liquidity_index;
  const auto remolded = kilo(site.remolded_strength_Pa);
  const auto& stability = known.stability_number;
  const Test flows_out = either(above("I_L", liquidity, 2), below("s_ur", remolded, 1, " kPa"));
  return {
      criterion("Mitchell and Markell", above("N_s", stability, 6)),
      criterion("Lebuis and Rissmann",
                either(above("I_L", liquidity, 1.2), below("s_ur", remolded, 1, " kPa"))),
      criterion("Lebuis et al., retrogression of 100 m",
                both(above("S_t", known.sensitivity, 25), below("s_ur", remolded, 1, " kPa"))),
      criterion(
          "Tavenas et al.",
          both(both(above("N_s", stability, 4), remolds_to_70_percent(site, known)), flows_out)),
      criterion("Tavenas et al., energy", more_energy_than_remolding(known)),
      criterion("Lefebvre", both(above("N_s", stability, 6), below("s_ur", remolded, 1.5, " kPa"))),
      criterion("Thakur and Degago", below("s_ur", remolded, 1, " kPa")),
      criterion("Demers et al.",
                both(below("s_ur", remolded, 0.8, " kPa"), above("I_L", liquidity, 1.5))),
  };
}

}  // namespace leda::solver
