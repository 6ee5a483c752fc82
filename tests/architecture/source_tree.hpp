#pragma once
// The source tree as text: its files, and what each includes.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace leda::architecture {

struct Include {
  int line = 0;
  std::string target;  ///< as written, without quotes or brackets
};

/// Path from the root, with '/', to the file's bytes.
using SourceTree = std::map<std::string, std::string>;

/// Every file below the root but what git and the builds keep there.
SourceTree read_source_tree(const std::filesystem::path& root);

bool is_cpp(const std::string& path);
bool is_text(const std::string& bytes);
std::vector<Include> includes_of(const std::string& text);

/// "solver", "disk", "profiles", "db", "server", "tests", "deploy"; empty outside the rooms.
std::string room_of(const std::string& path);

}  // namespace leda::architecture
