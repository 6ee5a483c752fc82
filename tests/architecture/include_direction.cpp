#include <algorithm>

#include "tests/architecture/house_rules.hpp"

namespace leda::architecture {

namespace {

const std::vector<std::string>& may_include(const std::string& room) {
  static const std::map<std::string, std::vector<std::string>> doors = {
      {"solver", {"solver/"}},
      {"profiles", {"profiles/", "solver/section/"}},
      {"db", {"db/", "solver/section/", "profiles/map/"}},
      {"server", {"server/", "db/", "profiles/", "solver/"}},
      {"tests", {"tests/", "server/", "db/", "profiles/", "solver/", "deploy/"}},
      {"deploy", {}}};
  return doors.at(room);
}

bool starts_with_one_of(const std::string& path, const std::vector<std::string>& starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](const std::string& start) { return path.starts_with(start); });
}

bool is_porch_header(const std::string& path) {
  return starts_with_one_of(path, {"solver/section/", "profiles/map/"}) && path.ends_with(".hpp");
}

bool is_standard_header(const std::string& target) {
  return target.find_first_of("./") == std::string::npos;
}

// A file that stands beside the includer, named without its room.
bool is_written_from_its_folder(const SourceTree& tree, const std::string& file,
                                const std::string& target) {
  const auto beside =
      (std::filesystem::path(file).parent_path() / target).lexically_normal().generic_string();
  return tree.contains(beside) && !tree.contains(target);
}

}  // namespace

std::vector<Breach> wrong_directions(const SourceTree& tree) {
  std::vector<Breach> found;
  for (const auto& [file, text] : tree) {
    const std::string room = room_of(file);
    if (!is_cpp(file) || room.empty()) continue;
    for (const Include& include : includes_of(text)) {
      if (is_written_from_its_folder(tree, file, include.target)) {
        found.push_back({file, include.line,
                         "\"" + include.target + "\" should be written from the repository root"});
      } else if (!room_of(include.target).empty() &&
                 !starts_with_one_of(include.target, may_include(room))) {
        found.push_back({file, include.line, room + "/ may not include " + include.target});
      }
    }
  }
  return found;
}

std::vector<Breach> porches_with_walls(const SourceTree& tree) {
  std::vector<Breach> found;
  for (const auto& [file, text] : tree) {
    if (!is_porch_header(file)) continue;
    for (const Include& include : includes_of(text))
      if (!is_standard_header(include.target) && !is_porch_header(include.target))
        found.push_back(
            {file, include.line,
             "a porch stands on the standard library and porches alone, not on " + include.target});
  }
  return found;
}

}  // namespace leda::architecture
