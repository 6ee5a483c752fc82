#pragma once
// Cells outside a survey that hold a number in place of ground, and a file that does not say so:
// the commonest fault of DEMs.

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "profiles/dem.hpp"

namespace leda::profiles {

struct UndeclaredFill {
  double value_m = 0;
  double share = 0;   ///< of all cells
  double step_m = 0;  ///< between such a cell and the ground beside it, on average
};

/// Counts the values that may be a fill: the lowest, the highest, and those programs like to write.
class RepeatedValues {
 public:
  void add(const std::vector<float>& metres);

  float lowest() const { return lowest_.value; }
  float highest() const { return highest_.value; }
  std::int64_t with_data() const { return with_data_; }
  /// Those that stand in at least this many cells.
  std::vector<float> at_least(std::int64_t cells) const;

 private:
  struct Count {
    float value = 0;
    std::int64_t cells = 0;
  };
  Count lowest_{std::numeric_limits<float>::infinity()};
  Count highest_{-std::numeric_limits<float>::infinity()};
  std::array<Count, 5> usual_{{{0.0F}, {-1.0F}, {1.0F}, {255.0F}, {999.0F}}};
  std::int64_t with_data_ = 0;
};

/// Values that fill whole pieces of the raster.
struct FoundFills {
  /// The one in most cells that the ground beside drops to, or rises to, more steeply than banks
  /// do. A lake or the sea, level as it is, has shores.
  std::optional<UndeclaredFill> taken;
  /// The others as steep (a mosaic has one of each survey), and those nearly as steep: they
  /// stay ground.
  std::vector<UndeclaredFill> unclear;
};

/// @param values of the whole raster; it is read again only where one of them repeats
FoundFills find_undeclared_fills(const Dem& dem, const RepeatedValues& values);

/// What a reader has to know of each, and what to do.
std::vector<std::string> warnings_of(const FoundFills& found);

}  // namespace leda::profiles
