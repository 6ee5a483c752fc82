#pragma once
// The data folder: leda.sqlite, rasters/, runs/<run id>/, exports/, server.json.

#include <filesystem>
#include <stdexcept>
#include <string>

namespace leda::server {

class DataFolderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class DataFolder {
 public:
  /// Makes what is missing. @throws DataFolderError naming the folder where that fails
  explicit DataFolder(const std::filesystem::path& root);

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path store() const { return root_ / "leda.sqlite"; }
  std::filesystem::path rasters() const { return root_ / "rasters"; }
  std::filesystem::path runs() const { return root_ / "runs"; }
  std::filesystem::path run(const std::string& id) const { return runs() / id; }
  std::filesystem::path exports() const { return root_ / "exports"; }
  std::filesystem::path uploads() const { return root_ / "uploads"; }
  std::filesystem::path server_file() const { return root_ / "server.json"; }

  /// A text for people outside, such as a worker's log: its paths begin in this folder, and do not
  /// tell where on the machine that is.
  std::string without_root(std::string text) const;

 private:
  std::filesystem::path root_;
};

/// One process at a time runs the jobs of a data folder. The lock ends with the process.
class RunnerLock {
 public:
  /// @throws DataFolderError where another process holds it
  explicit RunnerLock(const DataFolder& data);
  ~RunnerLock();
  RunnerLock(const RunnerLock&) = delete;
  RunnerLock& operator=(const RunnerLock&) = delete;

 private:
  int file_ = -1;
};

/// @throws DataFolderError naming the file
std::string read_whole(const std::filesystem::path& file);

/// `count` random hex digits.
std::string random_hex(std::size_t count);

}  // namespace leda::server
