#include "disk/new_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace leda::disk {

NewFile::NewFile(std::filesystem::path file) : file_(std::move(file)), part_(file_) {
  part_ += ".part";
}

NewFile::~NewFile() {
  std::error_code ignored;
  if (!kept_) std::filesystem::remove(part_, ignored);
}

void NewFile::keep() {
  sync_to_disk(part_);
  keep_in_memory();
  sync_to_disk(file_.has_parent_path() ? file_.parent_path() : ".");
}

void NewFile::keep_in_memory() {
  std::error_code error;
  std::filesystem::rename(part_, file_, error);
  if (error) throw FileError(file_.string() + " could not be written: " + error.message());
  kept_ = true;
}

void sync_to_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (synced) return;
  throw FileError(path.string() +
                  " could not be brought to the disk: " + std::generic_category().message(error));
}

}  // namespace leda::disk
