#include "tests/architecture/source_tree.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

namespace leda::architecture {

SourceTree read_source_tree(const std::filesystem::path& root) {
  const std::set<std::string> not_source = {".git", ".cache", "build", "demo-out", "node_modules"};
  SourceTree tree;
  std::filesystem::recursive_directory_iterator at(root), end;
  for (; at != end; ++at) {
    if (at->is_directory() && not_source.contains(at->path().filename().string())) {
      at.disable_recursion_pending();
      continue;
    }
    if (!at->is_regular_file()) continue;
    std::ifstream in(at->path(), std::ios::binary);
    tree[at->path().lexically_relative(root).generic_string()] =
        std::string(std::istreambuf_iterator<char>(in), {});
  }
  return tree;
}

bool is_cpp(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".hpp" || ending == ".cpp" || ending == ".h" || ending == ".c";
}

bool is_text(const std::string& bytes) { return bytes.find('\0') == std::string::npos; }

std::vector<Include> includes_of(const std::string& text) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::vector<Include> found;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_search(line, match, include)) found.push_back({number, match[1]});
  }
  return found;
}

std::string room_of(const std::string& path) {
  static const std::array<std::string, 7> rooms = {"solver", "disk",  "profiles", "db",
                                                   "server", "tests", "deploy"};
  const std::string first = path.substr(0, path.find('/'));
  const bool is_room =
      first.size() < path.size() && std::find(rooms.begin(), rooms.end(), first) != rooms.end();
  return is_room ? first : "";
}

}  // namespace leda::architecture
