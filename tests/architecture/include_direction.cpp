#include <algorithm>
#include <set>

#include "tests/architecture/house_rules.hpp"

namespace leda::architecture {

namespace {

const std::vector<std::string>& may_include(const std::string& room) {
  static const std::map<std::string, std::vector<std::string>> doors = {
      {"solver", {"solver/"}},
      {"disk", {"disk/"}},
      {"profiles", {"profiles/", "disk/", "solver/section/"}},
      {"db", {"db/", "disk/", "solver/section/", "profiles/map/"}},
      {"server", {"server/", "db/", "disk/", "profiles/", "solver/"}},
      {"tests", {"tests/", "server/", "db/", "disk/", "profiles/", "solver/", "deploy/"}},
      {"deploy", {}}};
  return doors.at(room);
}

using Doors = std::map<std::string, std::vector<std::string>>;

// The rooms inside solver/ (solver/README.md, "Rooms") and server/ (server/README.md, "Rooms"):
// what each may include beside itself.
const std::map<std::string, Doors>& inner_rooms() {
  static const std::map<std::string, Doors> rooms = {
      {"solver",
       {{"section", {}},
        {"materials", {"section"}},
        {"kernel", {"section", "materials"}},
        {"statics", {"section", "materials", "kernel"}},
        {"run", {"section", "materials", "kernel", "statics"}},
        {"extremes", {"section", "run"}},
        {"study", {"section"}},
        {"ensemble", {"section"}},
        {"hindcast", {"section", "ensemble"}},
        {"screening", {"section"}},
        {"element_test", {"section", "materials", "kernel"}}}},
      {"server",
       {{"operate", {}},
        {"documents", {}},
        {"drawings", {"documents"}},
        {"page", {}},
        {"run", {"documents", "operate"}},
        {"layers", {"run", "documents", "drawings", "operate"}},
        {"jobs", {"layers", "run", "documents", "drawings", "operate"}},
        {"http", {"jobs", "layers", "run", "documents", "drawings", "operate", "page"}},
        {"commands", {"http", "jobs", "layers", "run", "documents", "drawings", "operate"}}}}};
  return rooms;
}

// "kernel" of solver/kernel/step.hpp; empty for a file that stands in no room inside `room`.
std::string inner_room_of(const std::string& path, const std::string& room) {
  const std::string start = room + "/";
  const auto end = path.find('/', start.size());
  if (!path.starts_with(start) || end == std::string::npos) return "";
  return path.substr(start.size(), end - start.size());
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

// Headers that `file` leads to, depth first; a breach for every way back to a header on the path.
class CircleSearch {
 public:
  explicit CircleSearch(const SourceTree& tree) : tree_(tree) {}

  void from(const std::string& file) {
    if (std::ranges::find(path_, file) != path_.end()) return circle(file);
    const auto entry = tree_.find(file);
    if (entry == tree_.end() || !file.ends_with(".hpp") || !seen_.insert(file).second) return;
    path_.push_back(file);
    for (const Include& include : includes_of(entry->second)) from(include.target);
    path_.pop_back();
  }

  std::vector<Breach> found;

 private:
  void circle(const std::string& file) {
    std::string way;
    for (auto at = std::ranges::find(path_, file); at != path_.end(); ++at) way += *at + " > ";
    found.push_back({path_.back(), 0, "headers include each other: " + way + file});
  }

  const SourceTree& tree_;
  std::vector<std::string> path_;
  std::set<std::string> seen_;
};

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

std::vector<Breach> wrong_directions_inside(const SourceTree& tree) {
  std::vector<Breach> found;
  for (const auto& [file, text] : tree) {
    const std::string house = room_of(file);
    const auto rooms = inner_rooms().find(house);
    if (!is_cpp(file) || rooms == inner_rooms().end()) continue;
    const std::string room = inner_room_of(file, house);
    if (room.empty()) continue;
    const auto doors = rooms->second.find(room);
    if (doors == rooms->second.end()) {
      found.push_back({file, 0, house + "/" + room + "/ is no room of the " + house});
      continue;
    }
    for (const Include& include : includes_of(text)) {
      const std::string other = inner_room_of(include.target, house);
      if (other.empty() || other == room) continue;
      if (std::ranges::find(doors->second, other) == doors->second.end()) {
        found.push_back(
            {file, include.line, house + "/" + room + "/ may not include " + include.target});
      }
    }
  }
  return found;
}

std::vector<Breach> circles(const SourceTree& tree) {
  CircleSearch search(tree);
  for (const auto& [file, text] : tree) {
    if (!room_of(file).empty()) search.from(file);
  }
  return search.found;
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
