#pragma once
// A profile and the soil models of a region to the section that is simulated.

#include <map>
#include <string>
#include <vector>

#include "profiles/map/profile.hpp"
#include "profiles/map/soil_model.hpp"
#include "solver/section/section.hpp"
#include "solver/section/validate.hpp"

namespace leda::profiles {

/// Where a value of the built section came from.
struct SoilOrigin {
  std::size_t model = 0;  ///< index in the list of models
  std::string pointer;    ///< in that model
};

struct BuiltSection {
  Section section;
  std::size_t soil_model = 0;              ///< index of the model at the crest
  std::vector<std::size_t> column_models;  ///< of the section's columns
  std::map<std::string, SoilOrigin>
      materials;  ///< by name in the section; pointer: "/materials/clay"
  std::vector<std::string> warnings;
  std::vector<Fault> faults;  ///< the section stands where this is empty
};

/// At each place the model whose polygons hold it applies, else the first without polygons; where
/// that changes along the section, it has columns. The base is that of the model at the crest:
/// `base_m`, else `base_below_toe_m` below the toe. Pointers are relative to the list of models:
/// "/0/layers/1/bottom_m"; "" where no model applies.
BuiltSection build_section(const Profile& profile, const std::vector<SoilModel>& soil);

/// @param pointer into the built section: "/columns/1/layers/0", "/materials/clay (west)/k0"
SoilOrigin origin_of(const BuiltSection& built, const std::string& pointer);

}  // namespace leda::profiles
