#pragma once
// Tiny DEMs for tests: drawn as text, or computed from a function of the map.

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"

namespace leda::test {

/// A folder of the test's own, removed at its end.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct DrawnDem {
  int columns = 0, rows = 0;
  std::vector<float> cells;  ///< row by row; NaN is written as nodata
  std::array<double, 6> transform{1000, 1, 0, 2000, 0, -1};
  int epsg = 2950;  ///< 0: none
  std::string vertical_unit;
  int bands = 1;
  double nodata = -9999;
};

/// One character a cell: '0' to '9' times `step` metres, '.' for no data. North is at the top.
DrawnDem drawn(const std::vector<std::string>& rows, double step = 1, double cell = 1);

/// Elevations of cell centres by their place on the map.
DrawnDem computed(int columns, int rows, const std::array<double, 6>& transform,
                  const std::function<double(leda::MapPoint)>& elevation);

std::filesystem::path write_geotiff(const DrawnDem& dem, const std::filesystem::path& file);

}  // namespace leda::test
