#pragma once
// A folder to write in before a file is put in its place.

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace leda::profiles {

/// A folder of its own beside a file, on the same file system, gone with all it holds when done.
class WorkFolder {
 public:
  explicit WorkFolder(const std::filesystem::path& file) {
    std::string pattern = std::filesystem::absolute(file).string() + ".tmp-XXXXXX";
    if (mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~WorkFolder() {
    std::error_code ignored;
    if (exists()) std::filesystem::remove_all(path_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;

  /// False where it could not be made.
  bool exists() const { return !path_.empty(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace leda::profiles
