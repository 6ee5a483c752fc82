#pragma once
// Which soils a section runs over, and how far: one of them is taken for all of it.

#include <optional>
#include <string>
#include <vector>

#include "profiles/map/profile.hpp"
#include "profiles/map/soil_model.hpp"

namespace leda::profiles {

/// The model whose polygons hold a point, else the first without polygons.
std::optional<std::size_t> model_at(MapPoint p, const std::vector<SoilModel>& soil);

/// What the section leaves out by taking one soil for all of its length, and where polygons of
/// several models overlap, so that their order in the list decides.
std::vector<std::string> warnings_of_soils(const Profile& profile,
                                           const std::vector<SoilModel>& soil, std::size_t taken);

}  // namespace leda::profiles
