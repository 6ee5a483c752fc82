#include "db/new_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace leda::db {

namespace {

void sync_to_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int error = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!synced)
    throw std::runtime_error(path.string() + ": cannot be brought to the disk: " +
                             std::generic_category().message(error));
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
  sync_to_disk(part_);
  std::error_code error;
  std::filesystem::rename(part_, file_, error);
  if (error) throw std::runtime_error(file_.string() + ": " + error.message());
  kept_ = true;
  sync_to_disk(file_.has_parent_path() ? file_.parent_path() : ".");
}

}  // namespace leda::db
