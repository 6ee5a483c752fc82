#pragma once
// A file that appears whole or not at all.

#include <filesystem>
#include <stdexcept>

namespace leda::disk {

/// Names the file and the cause.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Written as "NAME.part" beside its place and renamed by keep(); otherwise removed. What a killed
/// program left behind under that name is overwritten by the next try.
class NewFile {
 public:
  explicit NewFile(std::filesystem::path file);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  const std::filesystem::path& part() const { return part_; }
  const std::filesystem::path& file() const { return file_; }

  /// Brings the bytes to the disk, then the name: it outlives a power cut. @throws FileError
  void keep();
  /// Only the name: readers see all or nothing. @throws FileError
  void keep_in_memory();

 private:
  std::filesystem::path file_;
  std::filesystem::path part_;
  bool kept_ = false;
};

/// Brings what was written to a file or folder to the disk. @throws FileError
void sync_to_disk(const std::filesystem::path& path);

/// Brings the bytes of a file to the disk, then its new name. @throws FileError
void rename_durably(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace leda::disk
