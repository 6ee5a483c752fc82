#pragma once
// Which soils a section runs over, and from where to where.

#include <optional>
#include <string>
#include <vector>

#include "profiles/map/profile.hpp"
#include "profiles/map/soil_model.hpp"

namespace leda::profiles {

/// The model whose polygons hold a point, else the first without polygons.
std::optional<std::size_t> model_at(MapPoint p, const std::vector<SoilModel>& soil);

/// A piece of a section on one soil.
struct SoilPart {
  double from_m = 0, to_m = 0;  ///< x of the profile
  std::size_t model = 0;
};

/// The pieces from end to end. A piece shorter than a hundredth of the section is the drawing's
/// inaccuracy and goes to its neighbour; so does ground on no soil. Empty where no soil applies.
std::vector<SoilPart> soil_parts(const Profile& profile, const std::vector<SoilModel>& soil);

/// Where no soil applies and a neighbour's is taken, and where polygons of several models overlap,
/// so that their order in the list decides.
std::vector<std::string> warnings_of_soils(const Profile& profile,
                                           const std::vector<SoilModel>& soil);

}  // namespace leda::profiles
