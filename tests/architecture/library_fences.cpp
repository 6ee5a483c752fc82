#include <array>
#include <regex>
#include <set>
#include <sstream>

#include "tests/architecture/house_rules.hpp"

namespace leda::architecture {

namespace {

struct Fence {
  std::string library;
  std::regex headers;
  std::string room;
};

const std::array<Fence, 4>& fences() {
  static const std::array<Fence, 4> all = {{
      {"GDAL", std::regex("(gdal/)?(gdal|ogr|cpl_|gnm|vrt|geos|proj)[a-z0-9_]*\\.(h|hpp)"),
       "profiles"},
      {"SQLite", std::regex("sqlite3(ext)?\\.h|SQLiteCpp/.*"), "db"},
      {"HDF5", std::regex("(hdf5/serial/)?(hdf5|hdf5_hl|H5[A-Za-z0-9_]*)\\.h|highfive/.*"), "db"},
      {"HTTP", std::regex("httplib\\.h"), "server"},
  }};
  return all;
}

// Tests look into every room. The demo's program is no part of Leda: it writes a DEM and ends.
bool is_free(const std::string& file) {
  return file.starts_with("tests/") || file.starts_with("deploy/demo/");
}

/// The way from a file to a header of the library, "a.hpp > b.hpp > gdal.h"; empty: none.
std::string way_to(const SourceTree& tree, const std::string& file, const std::regex& headers,
                   std::set<std::string>& seen) {
  const auto found = tree.find(file);
  if (found == tree.end() || !seen.insert(file).second) return "";
  for (const Include& include : includes_of(found->second)) {
    if (std::regex_match(include.target, headers)) return include.target;
    const std::string rest = way_to(tree, include.target, headers, seen);
    if (!rest.empty()) return include.target + " > " + rest;
  }
  return "";
}

}  // namespace

std::vector<Breach> open_fences(const SourceTree& tree) {
  std::vector<Breach> found;
  for (const auto& [file, text] : tree) {
    if (!is_cpp(file) || room_of(file).empty() || is_free(file)) continue;
    for (const Fence& fence : fences()) {
      if (room_of(file) == fence.room) continue;
      std::set<std::string> seen;
      const std::string way = way_to(tree, file, fence.headers, seen);
      if (!way.empty())
        found.push_back({file, 0, fence.library + " belongs to " + fence.room + "/: " + way});
    }
  }
  return found;
}

std::vector<Breach> inner_parts_of_httplib(const SourceTree& tree) {
  static const std::string the_one = "server/http/guarded_http.cpp";
  // Members that end in an underscore are the library's own; so are these.
  static const std::regex inner(
      R"(httplib::(detail|Stream|TaskQueue|ThreadPool)\b|: public httplib::Server)"
      R"(|process_and_close_socket|process_request\b|content_(length|provider)_)"
      R"(|new_task_queue|request\.ranges)");
  std::vector<Breach> found;
  for (const auto& [file, text] : tree) {
    if (!file.starts_with("server/") || !is_cpp(file) || file == the_one) continue;
    std::istringstream lines(text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      if (std::regex_search(line, inner)) {
        found.push_back({file, number, "inner parts of cpp-httplib belong to " + the_one});
      }
    }
  }
  return found;
}

}  // namespace leda::architecture
