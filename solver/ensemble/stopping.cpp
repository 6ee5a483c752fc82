#include "solver/ensemble/stopping.hpp"

namespace leda::solver {

const char* to_string(Ending ending) {
  switch (ending) {
    case Ending::more_members:
      return "more-members";
    case Ending::half_width:
      return "half-width";
    case Ending::max_members:
      return "max-members";
  }
  return "";
}

bool is_doubling(const StopRule& rule) {
  std::size_t members = rule.min_members;
  while (members > 0 && members < rule.max_members) members *= 2;
  return members > 0 && members == rule.max_members;
}

Ending ending(const StopRule& rule, std::size_t members, double half_width) {
  if (half_width <= rule.half_width) return Ending::half_width;
  return members < rule.max_members ? Ending::more_members : Ending::max_members;
}

}  // namespace leda::solver
