#include "solver/screening/site_material.hpp"

#include <algorithm>

#include "solver/section/fault_list.hpp"
#include "solver/section/warnings.hpp"

namespace leda::solver {
namespace {

constexpr double kilo = 1000;            // Pa in a kPa
constexpr double usual_stiffness = 100;  // G / s_up; thesis Tables 4-5 and 5-2: 47 to 123
constexpr double usual_remolded_Pa = 1e3;
constexpr double most_remolded_strain = 100;

UrmiSoftening law_of(const Site& site) {
  const SiteSoftening& known = *site.softening;
  const double by_eq_3_13 =
      std::max(1.0, 0.13 * site.peak_strength_Pa / kilo) * known.residual_strain;
  UrmiSoftening law;
  law.alpha = known.alpha;
  law.beta = known.beta;
  law.residual_strain = known.residual_strain;
  law.remolded_strength_Pa =
      site.remolded_strength_Pa.value_or(std::min(usual_remolded_Pa, 0.05 * site.peak_strength_Pa));
  law.residual_strength_Pa = site.residual_strength_Pa;
  law.remolded_strain = site.remolded_strain.value_or(std::min(by_eq_3_13, most_remolded_strain));
  return law;
}

/// What a site does not say is as clays have it, and neither odd nor a fault.
Material clay_of(const Site& site) {
  Material clay;
  clay.unit_weight = site.unit_weight;
  clay.peak_strength.constant_Pa = site.peak_strength_Pa;
  clay.shear_modulus_Pa = usual_stiffness * site.peak_strength_Pa;
  clay.poisson_ratio = 0.45;
  if (site.softening) {
    clay.softening = Softening{law_of(site)};
  } else if (site.remolded_strength_Pa) {
    clay.softening = Softening{ExponentialSoftening{*site.remolded_strength_Pa, 1}};
  }
  return clay;
}

std::string pointer_in_site(const std::string& in_material) {
  const std::string remolded = "/softening/remolded_strength_kPa";
  return in_material == remolded ? "/remolded_strength_kPa" : in_material;
}

}  // namespace

std::vector<Fault> faults_of_clay(const Site& site) {
  const std::string at = "/clay";
  std::vector<Fault> faults = validate_materials({{"clay", clay_of(site)}}, "");
  std::erase_if(faults, [&](const Fault& fault) {
    return fault.pointer == at + "/shear_modulus_kPa";  // follows from the strength
  });
  for (Fault& fault : faults) fault.pointer = pointer_in_site(fault.pointer.substr(at.size()));
  return faults;
}

std::vector<std::string> warnings_of(const Site& site) {
  std::vector<std::string> warnings = leda::warnings_of({{"clay", clay_of(site)}});
  const auto outside = [&](const char* key, double value, double least, double most,
                           const char* what) {
    if (value >= least && value <= most) return;
    warnings.push_back(std::string(key) + " is " + show(value) + ": " + what);
  };
  outside("height_m", site.height_m, 2, 150, "banks of sensitive clay are 5 to 70 m high");
  if (site.preconsolidation_Pa) {
    outside("preconsolidation_kPa", *site.preconsolidation_Pa / kilo, 10, 3000,
            "clays have 50 to 1000 kPa; is it in another unit?");
  }
  if (site.plasticity_index) {
    outside("plasticity_index_percent", *site.plasticity_index * 100, 1, 200,
            "clays have 5 to 60 per cent; is it a fraction?");
  }
  return warnings;
}

}  // namespace leda::solver
