#pragma once
// When there are members enough. Looked at by doublings alone: few looks, and nets stay whole.

#include <cstddef>

namespace leda::solver {

struct StopRule {
  std::size_t min_members = 64, max_members = 512;
  double half_width = 0.05;  ///< of the exceedance curves
  double confidence = 0.95;
};

enum class Ending { more_members, half_width, max_members };

const char* to_string(Ending ending);  ///< "more-members", "half-width", "max-members"

/// Whether max_members is min_members doubled some times.
bool is_doubling(const StopRule& rule);

/// @param half_width of the wider of both curves, over this many members
Ending ending(const StopRule& rule, std::size_t members, double half_width);

}  // namespace leda::solver
