#pragma once
// A profile and the soil models of a region to the section that is simulated.

#include <string>
#include <vector>

#include "profiles/map/profile.hpp"
#include "profiles/map/soil_model.hpp"
#include "solver/section/section.hpp"
#include "solver/section/validate.hpp"

namespace leda::profiles {

struct BuiltSection {
  Section section;
  std::size_t soil_model = 0;  ///< index of the model that applies
  std::vector<std::string> warnings;
  std::vector<Fault> faults;  ///< the section stands where this is empty
};

/// The model whose polygons hold the crest applies, else the first without polygons. The base is
/// `base_m`, else `base_below_toe_m` below the toe. Pointers are relative to the list of models:
/// "/0/layers/1/bottom_m"; "" where no model applies.
BuiltSection build_section(const Profile& profile, const std::vector<SoilModel>& soil);

}  // namespace leda::profiles
