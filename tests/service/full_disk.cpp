#include "tests/service/full_disk.hpp"

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include <string>

namespace leda::tests {

SmallDisk::SmallDisk(std::filesystem::path folder, std::size_t megabytes)
    : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
  if (megabytes == 0) return;
  const std::string options = "size=" + std::to_string(megabytes) + "m";
  mounted_ = mount("tmpfs", folder_.c_str(), "tmpfs", 0, options.c_str()) == 0;
}

SmallDisk::~SmallDisk() {
  if (mounted_) umount2(folder_.c_str(), MNT_DETACH);
}

void SmallDisk::fill() const {
  const int file = open(filler().c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  for (std::size_t size = std::size_t{1} << 20; size > 0;) {
    if (write(file, std::string(size, 'x').data(), size) <= 0) size /= 2;
  }
  close(file);
}

void SmallDisk::free() const { std::filesystem::remove(filler()); }

void limit_file_size(const std::vector<pid_t>& processes, bool limited) {
  for (const pid_t process : processes) {
    rlimit limit{};
    prlimit(process, RLIMIT_FSIZE, nullptr, &limit);
    limit.rlim_cur = limited ? 4096 : limit.rlim_max;
    prlimit(process, RLIMIT_FSIZE, &limit, nullptr);
  }
}

}  // namespace leda::tests
