#pragma once
// The ParaView export of a run: view.pvd opens as a time series of point clouds.

#include <filesystem>
#include <string>
#include <vector>

#include "solver/section/frame.hpp"

namespace leda::db {

/// Writes view/frame-0001.vtu, ... (VTK XML, unstructured grid, appended raw) as frames come, and
/// on close() the view.pvd that lists them. Each file appears whole or not at all. The section
/// lies in ParaView's x-y plane: x along the section, y elevation, both in metres.
class ViewWriter {
 public:
  /// @param folder an existing folder, that of the run's results
  explicit ViewWriter(std::filesystem::path folder);

  /// Throws std::invalid_argument where the frame's arrays differ in length, and
  /// std::runtime_error naming the file that could not be written.
  void append(const Frame& frame);
  void close();

 private:
  struct Entry {
    double time_s;
    std::string file;
  };
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
};

}  // namespace leda::db
