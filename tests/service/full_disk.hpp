#pragma once
// A folder whose disk can be filled: a small tmpfs where the test may mount one.

#include <sys/types.h>

#include <filesystem>
#include <vector>

namespace leda::tests {

class SmallDisk {
 public:
  /// Mounts a tmpfs of that size on the folder, which is made. Without the right to mount (root)
  /// the folder stays as it is, which is_mounted() tells; so it does at a size of 0.
  SmallDisk(std::filesystem::path folder, std::size_t megabytes);
  ~SmallDisk();
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool is_mounted() const { return mounted_; }
  const std::filesystem::path& folder() const { return folder_; }

  /// Leaves no byte free.
  void fill() const;
  void free() const;

 private:
  std::filesystem::path filler() const { return folder_ / "filler"; }
  std::filesystem::path folder_;
  bool mounted_ = false;
};

/// Where nothing can be mounted: these processes, and what they start, can write no byte beyond
/// the first 4096 of a file, or as many as they like again.
void limit_file_size(const std::vector<pid_t>& processes, bool limited);

}  // namespace leda::tests
