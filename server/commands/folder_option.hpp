#pragma once
// An option that names a folder to write into.

#include <filesystem>
#include <string>

namespace leda::server {

/// A check for CLI11: what is wrong with a path as a folder that is made where it is missing;
/// empty: nothing.
inline std::string no_folder(const std::string& path) {
  return std::filesystem::is_regular_file(path)
             ? "is '" + path + "', a file: name a folder, which is made where it is missing"
             : std::string();
}

}  // namespace leda::server
