#pragma once
// A profile cut from a DEM along a section's trace.

#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"
#include "solver/section/crest_and_toe.hpp"
#include "solver/section/geometry.hpp"

namespace leda {

struct Profile {
  std::string section;
  MapLine trace;    ///< where it was cut; x of the ground is the distance along it, m
  Polyline ground;  ///< metres in both directions
  CrestAndToe bank;
  std::vector<std::string> warnings;  ///< for example: shortened at nodata
};

/// A section of the layout that could not be cut: the job goes on without it.
struct LeftOut {
  std::string section;
  MapLine trace;
  std::string reason;
};

}  // namespace leda
