#include "tests/architecture/house_rules.hpp"

namespace leda::architecture {

std::ostream& operator<<(std::ostream& out, const Breach& breach) {
  out << breach.file;
  if (breach.line > 0) out << ':' << breach.line;
  return out << ": " << breach.what;
}

std::vector<Breach> all_breaches(const SourceTree& tree) {
  std::vector<Breach> all;
  for (const auto rule :
       {wrong_directions, wrong_directions_inside, circles, porches_with_walls, open_fences,
        inner_parts_of_httplib, drawers, strays_at_the_top, machine_paths, long_lines})
    for (Breach& breach : rule(tree)) all.push_back(std::move(breach));
  return all;
}

}  // namespace leda::architecture
