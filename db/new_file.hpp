#pragma once
// A file that appears whole or not at all. Private to db/.

#include <filesystem>

namespace leda::db {

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

  /// Brings the bytes to the disk, then the name. Throws std::runtime_error naming the file.
  void keep();

 private:
  std::filesystem::path file_;
  std::filesystem::path part_;
  bool kept_ = false;
};

}  // namespace leda::db
