#include "tests/disk/synced_paths.hpp"

#include <sys/syscall.h>
#include <unistd.h>

#include <mutex>
#include <string>
#include <system_error>
#include <utility>

namespace {

std::mutex one_at_a_time;
std::vector<std::filesystem::path>& synced() {
  static std::vector<std::filesystem::path> paths;
  return paths;
}

void record(int descriptor) {
  std::error_code ignored;
  auto path = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), ignored);
  const std::lock_guard lock(one_at_a_time);
  synced().push_back(std::move(path));
}

}  // namespace

// In place of the C library's: files and folders are brought to the disk by the one, SQLite's by
// the other.
extern "C" int fsync(int descriptor) {
  record(descriptor);
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}
extern "C" int fdatasync(int descriptor) {
  record(descriptor);
  return static_cast<int>(syscall(SYS_fdatasync, descriptor));
}

namespace leda::tests {

std::vector<std::filesystem::path> take_synced_paths() {
  const std::lock_guard lock(one_at_a_time);
  return std::exchange(synced(), {});
}

bool in_order(const std::vector<std::filesystem::path>& wanted,
              const std::vector<std::filesystem::path>& synced) {
  auto next = wanted.begin();
  for (const auto& path : synced) {
    if (next != wanted.end() && path == *next) ++next;
  }
  return next == wanted.end();
}

}  // namespace leda::tests
