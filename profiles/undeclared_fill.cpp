#include "profiles/undeclared_fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace leda::profiles {
namespace {

constexpr int strip_cells = 512;  // the raster is read in squares of this side
constexpr double least_share = 1e-4;
constexpr std::int64_t least_cells = 16;
// Over a whole shore, cell to cell, ground does not climb more steeply than this (56 degrees).
constexpr double steepest_shore = 1.5;
constexpr double least_step_m = 1.5;
constexpr double share_told = 0.75;  // of that step: what stands there may be either

/// Cells of one value and what lies beside them.
struct Beside {
  float value = 0;
  std::int64_t cells = 0;
  std::int64_t equal = 0;  // pairs of such cells
  std::int64_t other = 0;  // pairs of one and a cell of ground
  double steps_m = 0;      // summed over them

  void look_at(float a, float b) {
    const bool first = a == value, second = b == value;
    if (first && second) {
      ++equal;
    } else if ((first || second) && !std::isnan(a) && !std::isnan(b)) {
      ++other;
      steps_m += std::abs(static_cast<double>(a) - b);
    }
  }
};

void look_at_square(const std::vector<float>& cells, std::size_t width, Beside& beside) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i] == beside.value) ++beside.cells;
    if ((i + 1) % width != 0) beside.look_at(cells[i], cells[i + 1]);
    if (i + width < cells.size()) beside.look_at(cells[i], cells[i + width]);
  }
}

template <class Use>
void for_each_square(const Dem& dem, const Use& use) {
  const int columns = dem.info().width, rows = dem.info().height;
  for (int row = 0; row < rows; row += strip_cells) {
    for (int column = 0; column < columns; column += strip_cells) {
      const int width = std::min(strip_cells, columns - column);
      const int height = std::min(strip_cells, rows - row);
      use(dem.read(column, row, width, height, width, height), static_cast<std::size_t>(width));
    }
  }
}

bool in_pieces(const Beside& beside) { return beside.equal >= beside.cells && beside.other > 0; }

std::string told(const UndeclaredFill& fill) {
  return fmt::format(
      "{:.2g} % of the cells are exactly {:g} m and the ground beside them stands {:.1f} m away: ",
      100 * fill.share, fill.value_m, fill.step_m);
}

}  // namespace

void RepeatedValues::add(const std::vector<float>& metres) {
  for (const float z : metres) {
    if (std::isnan(z)) continue;
    ++with_data_;
    if (z < lowest_.value) lowest_ = {z, 0};
    if (z > highest_.value) highest_ = {z, 0};
    if (z == lowest_.value) ++lowest_.cells;
    if (z == highest_.value) ++highest_.cells;
    for (Count& usual : usual_) {
      if (z == usual.value) ++usual.cells;
    }
  }
}

std::vector<float> RepeatedValues::at_least(std::int64_t cells) const {
  std::vector<float> values;
  const auto take = [&](const Count& count) {
    const bool known = std::ranges::find(values, count.value) != values.end();
    if (count.cells >= cells && !known) values.push_back(count.value);
  };
  take(lowest_);
  take(highest_);
  for (const Count& usual : usual_) take(usual);
  return values;
}

FoundFills find_undeclared_fills(const Dem& dem, const RepeatedValues& values) {
  const double all = static_cast<double>(dem.info().width) * dem.info().height;
  const auto enough = std::max(least_cells, static_cast<std::int64_t>(least_share * all));
  std::vector<Beside> besides;
  for (const float value : values.at_least(enough)) besides.push_back({.value = value});
  FoundFills found;
  if (besides.empty()) return found;
  for_each_square(dem, [&](const std::vector<float>& cells, std::size_t width) {
    for (Beside& beside : besides) look_at_square(cells, width, beside);
  });
  const double steep = std::max(least_step_m, steepest_shore * dem.info().cell_m());
  for (const Beside& beside : besides) {
    if (!in_pieces(beside)) continue;
    const UndeclaredFill fill{static_cast<double>(beside.value),
                              static_cast<double>(beside.cells) / all,
                              beside.steps_m / static_cast<double>(beside.other)};
    if (fill.step_m < share_told * steep) continue;
    if (fill.step_m < steep || (found.taken && found.taken->share >= fill.share)) {
      found.unclear.push_back(fill);
    } else {
      if (found.taken) found.unclear.push_back(*found.taken);
      found.taken = fill;
    }
  }
  return found;
}

std::vector<std::string> warnings_of(const FoundFills& found) {
  std::vector<std::string> warnings;
  if (found.taken) {
    warnings.push_back(told(*found.taken) +
                       "they are taken for cells without data, which nobody declared. Declare them "
                       "(gdal_edit.py -a_nodata VALUE, or nodata = VALUE), or say that they are "
                       "ground (nodata = none)");
  }
  for (const UndeclaredFill& fill : found.unclear) {
    warnings.push_back(told(fill) +
                       "they count as ground. If they hold no data, give all such cells one value "
                       "and declare it (nodata = VALUE)");
  }
  return warnings;
}

}  // namespace leda::profiles
