#include "solver/kernel/sort_particles.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

bool sort_particles(Particles& particles, Grid& grid) {
  const double per_h = 1 / grid.h;
  const auto columns = static_cast<double>(grid.columns), rows = static_cast<double>(grid.rows);
  std::vector<std::uint32_t> cell(particles.count);
  std::vector<std::uint32_t> start(grid.columns * grid.rows + 1, 0);
  std::vector<std::size_t> highest(grid.columns, 0);
  for (std::size_t i = 0; i < particles.count; ++i) {
    const double column = std::floor(particles.x[i] * per_h + 0.5);
    const double row = std::floor(particles.z[i] * per_h + 0.5);
    // Written so that a position that is not a number fails too.
    if (!(column >= 0 && column + 3 <= columns && row >= 0 && row + 4 <= rows)) return false;
    const auto c = static_cast<std::size_t>(column), r = static_cast<std::size_t>(row);
    cell[i] = static_cast<std::uint32_t>(grid.index(c, r));
    ++start[cell[i] + 1];
    highest[c] = std::max(highest[c], r + 1);
  }
  for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
  std::vector<std::int32_t> order(particles.count);
  for (std::size_t i = 0; i < particles.count; ++i) {
    order[start[cell[i]]++] = static_cast<std::int32_t>(i);
  }
  particles.reorder(order);
  // A particle of column c sees columns c to c + 2; before the next sort it may move one cell.
  for (std::size_t c = 0; c < grid.columns; ++c) {
    std::size_t top = 0;
    for (std::size_t from = c >= 3 ? c - 3 : 0; from <= std::min(c + 1, grid.columns - 1); ++from) {
      if (highest[from] > 0) top = std::max(top, highest[from] + 3);
    }
    grid.top[c] = std::min(top, grid.rows);
  }
  clear(grid);
  return true;
}

}  // namespace leda::solver
