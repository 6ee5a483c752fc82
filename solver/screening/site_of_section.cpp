#include "solver/screening/site_of_section.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "solver/screening/toe_cut.hpp"

namespace leda::solver {
namespace {

constexpr int probes = 200;
constexpr double base_below_toe_m = 5;
/// Stiffness decides nothing in screening; a section must have one.
constexpr double shear_modulus_over_strength = 100;

/// A material along a vertical: how much of it, and its mean strength there.
struct Share {
  double metres = 0;
  double strength_sum = 0;
  int count = 0;
};

/// Materials along the vertical under the crest between two elevations.
std::map<std::string, Share> probe(const Section& section, double x, double top, double bottom) {
  std::map<std::string, Share> shares;
  const double ground = elevation_at(section.ground, x);
  const double step = (top - bottom) / probes;
  for (int i = 0; i < probes; ++i) {
    const double z = top - (i + 0.5) * step;
    const std::string& name = layer_at(section, {x, z}).material;
    Share& share = shares[name];
    share.metres += step;
    share.strength_sum += section.materials.at(name).peak_strength.at(ground - z, z);
    ++share.count;
  }
  return shares;
}

using Named = std::pair<std::string, Share>;

std::optional<Named> thickest(const Section& section, const std::map<std::string, Share>& shares,
                              bool softening_only) {
  std::optional<Named> best;
  for (const auto& [name, share] : shares) {
    if (softening_only && !section.materials.at(name).softening) continue;
    if (!best || share.metres > best->second.metres) best = {name, share};
  }
  return best;
}

double remolded_strength_of(const SofteningLaw& law) {
  return std::visit([](const auto& l) { return l.remolded_strength_Pa; }, law);
}

void add_softening(const Material& material, Site& site) {
  if (!material.softening) return;
  site.remolded_strength_Pa = remolded_strength_of(material.softening->law);
  if (const auto* urmi = std::get_if<UrmiSoftening>(&material.softening->law)) {
    site.softening = SiteSoftening{urmi->alpha, urmi->beta, urmi->residual_strain};
    site.residual_strength_Pa = urmi->residual_strength_Pa;
    site.remolded_strain = urmi->remolded_strain;
  }
}

}  // namespace

std::optional<Site> site_of(const Section& section) {
  const auto bank = bank_of(section);
  if (!bank || bank->crest.z <= bank->toe.z) return std::nullopt;
  const auto above = probe(section, bank->crest.x, bank->crest.z, bank->toe.z);
  auto clay = thickest(section, above, true);
  if (!clay && bank->toe.z > section.base_m) {
    clay = thickest(section, probe(section, bank->crest.x, bank->toe.z, section.base_m), true);
  }
  if (!clay) clay = thickest(section, above, false);

  Site site;
  site.height_m = bank->crest.z - bank->toe.z;
  site.slope_angle_deg =
      std::atan2(site.height_m, std::abs(bank->toe.x - bank->crest.x)) * 180 / std::numbers::pi;
  for (const auto& [name, share] : above) {
    site.unit_weight += section.materials.at(name).unit_weight * share.metres / site.height_m;
  }
  const Material& material = section.materials.at(clay->first);
  site.peak_strength_Pa = clay->second.strength_sum / clay->second.count;
  if (material.shear_modulus_Pa > 0) {
    site.peak_strain = site.peak_strength_Pa / material.shear_modulus_Pa;
  }
  add_softening(material, site);
  return site;
}

Section section_of(const Site& site) {
  const double height = site.height_m;
  const double run = height / std::tan(*site.slope_angle_deg * std::numbers::pi / 180);
  const double level = 4 * height;
  Section section;
  section.name = "site";
  section.ground = {{0, height}, {level, height}, {level + run, 0}, {2 * level + run, 0}};
  section.base_m = -base_below_toe_m;
  section.water_table = WaterTable{0.0, {}};
  section.crest = section.ground[1];
  section.toe = section.ground[2];

  Material clay;
  clay.unit_weight = site.unit_weight;
  clay.peak_strength.constant_Pa = site.peak_strength_Pa;
  clay.shear_modulus_Pa = shear_modulus_over_strength * site.peak_strength_Pa;
  clay.poisson_ratio = 0.45;
  if (site.remolded_strength_Pa && *site.remolded_strength_Pa < site.peak_strength_Pa) {
    // Which law does not matter to a factor of safety: that there is one does.
    clay.softening = Softening{ExponentialSoftening{*site.remolded_strength_Pa, 1.0}};
  }
  section.materials["clay"] = clay;
  Layer layer;
  layer.material = "clay";
  section.layers = {layer};
  return section;
}

}  // namespace leda::solver
