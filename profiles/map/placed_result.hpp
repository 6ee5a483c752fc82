#pragma once
// A section's result, back on the map.

#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"
#include "solver/section/section_result.hpp"

namespace leda {

/// Points on the section's trace. A section without movement has backscarp == toe and
/// front == toe; one without a result (failed, unstable, left out) has `known` false.
struct PlacedResult {
  std::string section;
  int line = 0;      ///< sections of one line are neighbours in `order`; named lines: -1
  double order = 0;  ///< position along the line, m
  bool known = false;
  bool moved = false;
  MapPoint backscarp, crest, toe, front;
  double retrogression_m = 0;
  double runout_m = 0;
  Bound retrogression_is = Bound::measured;
  Bound runout_is = Bound::measured;
  std::vector<std::string> warnings;
  std::string made_by;  ///< hash of case and program
};

}  // namespace leda
