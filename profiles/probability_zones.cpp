#include "profiles/probability_zones.hpp"

#include <algorithm>
#include <iterator>

#include "profiles/areas.hpp"
#include "profiles/place_result.hpp"

namespace leda::profiles {
namespace {

/// From the crest to the end of the section behind it, and from the toe to the other end, m.
struct Room {
  double behind_m = 0, ahead_m = 0;
};

/// +1 where the slope goes down to growing x.
double downhill(const Profile& profile) {
  return profile.bank.toe.x > profile.bank.crest.x ? 1 : -1;
}

Room room_of(const Profile& profile) {
  const double first = profile.ground.front().x, last = profile.ground.back().x;
  const auto& [crest, toe] = profile.bank;
  if (downhill(profile) > 0) return {crest.x - first, last - toe.x};
  return {last - crest.x, toe.x - first};
}

/// What a run with these distances would have left.
SectionResult result_with(const Profile& profile, const QuantileDistance& retrogression,
                          const QuantileDistance& runout) {
  const Room room = room_of(profile);
  const double way = downhill(profile);
  SectionResult result;
  result.status = RunStatus::at_rest;
  result.crest_to_crest_retrogression_m = retrogression.distance_m.value_or(room.behind_m);
  result.runout_m = runout.distance_m.value_or(room.ahead_m);
  result.retrogression_is = retrogression.distance_m ? retrogression.is : Bound::lower_bound;
  result.runout_is = runout.distance_m ? runout.is : Bound::lower_bound;
  result.backscarp.x = profile.bank.crest.x - way * result.crest_to_crest_retrogression_m;
  result.front.x = profile.bank.toe.x + way * result.runout_m;
  return result;
}

PlacedResult placed_with(const SectionQuantiles& section, const QuantileDistance& retrogression,
                         const QuantileDistance& runout) {
  const Profile& profile = section.profile;
  if (!section.reason.empty()) {
    return place_unknown(profile.section, profile.trace, section.line, section.order,
                         section.reason);
  }
  PlacedResult placed = place_result(profile, section.line, section.order,
                                     result_with(profile, retrogression, runout), section.made_by);
  placed.warnings.insert(placed.warnings.end(), section.warnings.begin(), section.warnings.end());
  return placed;
}

std::vector<Zone> zones_at(const std::vector<SectionQuantiles>& sections, std::size_t exceedance,
                           const ZonationOptions& options) {
  std::vector<PlacedResult> placed;
  for (const SectionQuantiles& section : sections) {
    const bool known = section.reason.empty();
    placed.push_back(placed_with(section,
                                 known ? section.retrogression.at(exceedance) : QuantileDistance{},
                                 known ? section.runout.at(exceedance) : QuantileDistance{}));
  }
  return make_zones(placed, options);
}

int fewest_members(const Zone& zone, const std::vector<SectionQuantiles>& sections) {
  int fewest = 0;
  for (const SectionQuantiles& section : sections) {
    if (std::ranges::find(zone.sections, section.profile.section) == zone.sections.end()) continue;
    fewest = fewest == 0 ? section.members : std::min(fewest, section.members);
  }
  return fewest;
}

/// A chain of sections at a higher probability is part of one at a lower probability: what moves
/// more seldom moves on the same sections or fewer.
bool is_part_of(const Zone& inner, const Zone& outer) {
  return inner.kind == outer.kind && !inner.sections.empty() &&
         std::ranges::find(outer.sections, inner.sections.front()) != outer.sections.end();
}

void take_in(Zone& outer, const std::vector<Zone>& inner_zones) {
  const std::size_t own = outer.area.size();
  for (const Zone& inner : inner_zones) {
    if (is_part_of(inner, outer)) {
      outer.area.insert(outer.area.end(), inner.area.begin(), inner.area.end());
    }
  }
  if (outer.area.size() > own) outer.area = union_of(outer.area);
}

}  // namespace

std::vector<Zone> probability_zones(const std::vector<SectionQuantiles>& sections,
                                    const std::vector<double>& exceedance,
                                    const ZonationOptions& options) {
  std::vector<std::vector<Zone>> levels(exceedance.size());
  for (std::size_t i = exceedance.size(); i-- > 0;) {
    levels[i] = zones_at(sections, i, options);
    for (Zone& zone : levels[i]) {
      if (i + 1 < levels.size()) take_in(zone, levels[i + 1]);
      zone.probability = ZoneProbability{exceedance[i], fewest_members(zone, sections)};
    }
  }
  std::vector<Zone> zones;
  for (auto& level : levels) {
    std::ranges::move(level, std::back_inserter(zones));
  }
  return zones;
}

std::vector<Zone> zones_spoken_of(const std::vector<SectionQuantiles>& sections,
                                  const ZonationOptions& options) {
  std::vector<PlacedResult> placed;
  for (const SectionQuantiles& section : sections) {
    placed.push_back(placed_with(section, {}, {}));  // as far as there is ground
  }
  return make_zones(placed, options);
}

}  // namespace leda::profiles
