#include "solver/screening/analytics.hpp"

#include "solver/screening/criteria.hpp"
#include "solver/screening/empirical_retrogression.hpp"
#include "solver/screening/remolding_energy.hpp"
#include "solver/screening/slide_energy.hpp"
#include "solver/screening/strength_ratios.hpp"

namespace leda::solver {
namespace {

/// What the complete curve lacks, in words.
std::string missing_of_curve(const Site& site) {
  std::string names;
  const auto add = [&](const char* name) {
    names += (names.empty() ? "" : ", ") + std::string(name);
  };
  if (!site.softening) add("softening by eq. 3-10");
  if (!site.remolded_strength_Pa) add("remolded strength");
  if (!site.peak_strain && !site.preconsolidation_Pa) add("peak strain (or preconsolidation)");
  return "not given: " + names;
}

void add_strength_ratios(const Site& site, Analytics& a) {
  a.stability_number = stability_number(site.unit_weight, site.height_m, site.peak_strength_Pa);
  if (!site.remolded_strength_Pa) {
    a.missing["sensitivity"] = a.missing["brittleness_index"] = "not given: remolded strength";
    return;
  }
  a.sensitivity = sensitivity(site.peak_strength_Pa, *site.remolded_strength_Pa);
  a.brittleness_index = brittleness_index(site.peak_strength_Pa, *site.remolded_strength_Pa);
}

void add_limit_state(const Site& site, Analytics& a) {
  a.peak_strain = site.peak_strain;
  if (site.preconsolidation_Pa) {
    a.limit_state_energy = limit_state_energy(*site.preconsolidation_Pa);
    if (!a.peak_strain) {
      a.peak_strain = peak_strain_from(*a.limit_state_energy, site.peak_strength_Pa);
    }
  } else {
    a.missing["limit_state_energy"] = "not given: preconsolidation";
    if (!a.peak_strain) a.missing["peak_strain"] = "not given: peak strain or preconsolidation";
  }
}

void add_remolding(const Site& site, Analytics& a) {
  if (site.plasticity_index) {
    a.remolding.leroueil = remolding_energy_leroueil(site.peak_strength_Pa, *site.plasticity_index);
  } else {
    a.missing["remolding_energy_by.leroueil"] = "not given: plasticity index";
  }
  const auto curve = post_peak_curve(site);
  if (!curve) {
    const std::string why = missing_of_curve(site);
    for (const char* name :
         {"remolding_energy", "remolding_energy_by.complete_curve", "remolding_energy_by.linear",
          "remolding_energy_by.thesis_reading", "destruction_index"}) {
      a.missing[name] = why;
    }
    return;
  }
  a.remolding.complete_curve = remolding_energy(*curve);
  a.remolding.linear = remolding_energy_linear(*curve);
  a.remolding.thesis_reading = remolding_energy_thesis_reading(*curve);
  a.destruction_index = destruction_index(*a.potential_energy, *a.remolding.complete_curve);
}

/// Both modes of eq. 3-22, each with its own energy and its own line.
void add_urmi(const Site& site, Analytics& a) {
  std::string why;
  if (!a.remolding.complete_curve) why = missing_of_curve(site);
  if (!site.liquidity_index)
    why = why.empty() ? "not given: liquidity index" : why + ", liquidity index";
  if (!why.empty()) {
    a.missing["urmi_2023_thesis"] = a.missing["urmi_2023_corrected"] = why;
    return;
  }
  const auto estimate = [&](double energy, const OmegaLine& line) {
    return urmi_2023(*a.potential_energy, energy, *site.liquidity_index, site.unit_weight, line);
  };
  const Estimate thesis = estimate(*a.remolding.thesis_reading, omega_thesis());
  const Estimate corrected = estimate(*a.remolding.complete_curve, omega_corrected());
  a.retrogression.urmi_2023_thesis = thesis.metres;
  a.retrogression.urmi_2023_corrected = corrected.metres;
  a.retrogression.urmi_2023_corrected_range = corrected.range;
  if (!thesis.metres) a.missing["urmi_2023_thesis"] = thesis.why_not;
  if (!corrected.metres) a.missing["urmi_2023_corrected"] = corrected.why_not;
}

void add_neighbours(const Site& site, Analytics& a) {
  if (site.slope_angle_deg) {
    a.retrogression.quinn_2011 = quinn_2011(site.height_m, *site.slope_angle_deg);
  } else {
    a.missing["quinn_2011"] = "not given: slope angle";
  }
  a.retrogression.carson_lajoie_1981 = carson_lajoie_1981(site.height_m);
  const Estimate mitchell = mitchell_markell_1974(*a.stability_number);
  a.retrogression.mitchell_markell_1974 = mitchell.metres;
  if (!mitchell.metres) a.missing["mitchell_markell_1974"] = mitchell.why_not;
  a.retrogression.nve_1_15 = nve_1_15(site.height_m);
}

}  // namespace

Analytics analyse(const Site& site) {
  Analytics a;
  a.potential_energy = potential_energy(site.unit_weight, site.height_m);
  add_strength_ratios(site, a);
  add_limit_state(site, a);
  add_remolding(site, a);
  add_urmi(site, a);
  add_neighbours(site, a);
  a.criteria = retrogression_criteria(site, a);
  return a;
}

}  // namespace leda::solver
