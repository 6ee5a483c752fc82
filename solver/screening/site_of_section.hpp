#pragma once
// Between a section and the site that the closed formulas know.

#include <optional>

#include "solver/screening/site.hpp"
#include "solver/section/section.hpp"

namespace leda::solver {

/// The bank of a section as a site: height and angle from crest to toe, unit weight averaged over
/// the bank, strengths and softening of the softening material that is thickest under the crest
/// (above the toe, else below it; without one, the thickest material of the bank).
/// @return nothing where the section has no bank
std::optional<Site> site_of(const Section& section);

/// A plane bank of the site's height and angle, of its clay alone, on a firm base 5 m below the
/// toe (the default of a soil model), with four heights of level ground to either side and the
/// water at the ground. The clay counts as softening where its remolded strength is below its peak.
/// @pre the site has a slope angle
Section section_of(const Site& site);

}  // namespace leda::solver
