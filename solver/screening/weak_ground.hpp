#pragma once
// What screening takes where strength varies within the ground: too little rather than too much.

#include <optional>
#include <string>

#include "solver/section/section.hpp"

namespace leda::solver {

/// The section with the 5 % fractile of each random field in place of its mean, without a field:
/// that of a point, not of an average along a slip surface (solver/screening/README.md, "Strength
/// that varies"). Nothing where no strength varies.
std::optional<Section> weak_ground(const Section& section);

/// In words what weak_ground does to the materials; empty where it does nothing.
std::string told_of_weak_ground(const Section& section);

}  // namespace leda::solver
