#include "disk/new_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace leda::disk {
namespace {

void give_name(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::rename(from, to, error);
  if (error) throw FileError(to.string() + " could not be written: " + error.message());
}

}  // namespace

NewFile::NewFile(std::filesystem::path file) : file_(std::move(file)), part_(file_) {
  part_ += ".part";
}

NewFile::~NewFile() {
  std::error_code ignored;
  if (!kept_) std::filesystem::remove(part_, ignored);
}

void NewFile::keep() {
  rename_durably(part_, file_);
  kept_ = true;
}

void NewFile::keep_in_memory() {
  give_name(part_, file_);
  kept_ = true;
}

void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to) {
  sync_to_disk(from);
  give_name(from, to);
  sync_to_disk(to.has_parent_path() ? to.parent_path() : ".");
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
