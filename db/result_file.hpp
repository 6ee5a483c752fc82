#pragma once
// fields.h5: the particles of a run over time. Layout: db/README.md.

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "solver/section/frame.hpp"

namespace leda::db {

/// Writes frames under a temporary name beside `file` and renames on close(); a file that is
/// not closed is removed. Throws std::runtime_error naming the file when HDF5 fails.
class ResultFileWriter {
 public:
  ResultFileWriter(const std::filesystem::path& file, const std::vector<std::string>& materials,
                   const std::string& case_sha256, const std::string& version);
  ~ResultFileWriter();
  ResultFileWriter(const ResultFileWriter&) = delete;
  ResultFileWriter& operator=(const ResultFileWriter&) = delete;

  void append(const Frame& frame);
  void close();

 private:
  struct File;
  std::unique_ptr<File> file_;
};

/// @return every frame of a file, in time order
std::vector<Frame> read_result_file(const std::filesystem::path& file);

}  // namespace leda::db
