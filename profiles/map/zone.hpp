#pragma once
// Release and runout zones: the product.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"
#include "solver/section/section_result.hpp"

namespace leda {

enum class ZoneKind { release, runout };

/// Of the zones of an ensemble, conditional on a slide starting at each of their sections.
struct ZoneProbability {
  double exceedance = 0;  ///< probability that a section's distance goes beyond the zone's edge
  int members = 0;        ///< fewest of one of its sections
};

struct Zone {
  ZoneKind kind = ZoneKind::release;
  std::vector<MapPolygon> area;       ///< a valid multipolygon
  std::vector<std::string> sections;  ///< whose results made it
  /// Absent: of the sections' own runs.
  std::optional<ZoneProbability> probability = std::nullopt;
  double largest_distance_m = 0;  ///< retrogression, or runout
  double mean_distance_m = 0;
  Bound distance_is = Bound::measured;  ///< a lower bound where one of its sections has one
  std::vector<std::string> warnings;
  std::string made_by;  ///< sha256 over what made it
};

/// The layers that zones are shown and exported in.
enum class ZoneLayer { release, runout, probability };

inline constexpr std::array all_zone_layers{ZoneLayer::release, ZoneLayer::runout,
                                            ZoneLayer::probability};

inline const char* to_string(ZoneKind kind) {
  return kind == ZoneKind::release ? "release" : "runout";
}

/// "release_zones", "runout_zones", "probability_zones"
inline const char* to_string(ZoneLayer layer) {
  if (layer == ZoneLayer::probability) return "probability_zones";
  return layer == ZoneLayer::release ? "release_zones" : "runout_zones";
}

inline ZoneLayer layer_of(const Zone& zone) {
  if (zone.probability) return ZoneLayer::probability;
  return zone.kind == ZoneKind::release ? ZoneLayer::release : ZoneLayer::runout;
}

}  // namespace leda
