#pragma once
// Which sections to cut: named lines, or a spacing along a line. Coordinates in the DEM's CRS.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "profiles/map/coordinates.hpp"

namespace leda {

struct NamedLine {
  std::string name;
  MapLine line;                                  ///< at least two points
  std::optional<MapPoint> crest = std::nullopt;  ///< by hand: the nearest point of the line counts
  std::optional<MapPoint> toe = std::nullopt;    ///< absent: found by find_crest_and_toe
};

/// Sections perpendicular to a (smoothed) line, a river or a crest, named S001, S002, ...
struct SectionsAlong {
  MapLine along;
  double spacing_m = 0;
  double upslope_m = 0;    ///< length on the uphill side
  double downslope_m = 0;  ///< length on the other side
};

struct SectionLayout {
  std::vector<NamedLine> lines;
  std::vector<SectionsAlong> along;
};

}  // namespace leda
