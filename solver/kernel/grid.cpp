#include "solver/kernel/grid.hpp"

#include <algorithm>
#include <cmath>

namespace leda::solver {

Grid make_grid(double h, double length, double height) {
  Grid grid;
  grid.h = h;
  grid.columns = static_cast<std::size_t>(std::ceil(length / h - 1e-9)) + 3;
  grid.rows = static_cast<std::size_t>(std::ceil(height / h - 1e-9)) + 3;
  const std::size_t nodes = grid.columns * grid.rows;
  grid.node.assign(nodes * Grid::width + 16, 0.0);
  grid.velocity.assign(nodes * 2 + 8, 0.0);
  grid.top.assign(grid.columns, 0);
  return grid;
}

void average_spans(Grid& grid) { grid.span.assign(grid.columns * grid.rows * 3, 0.0); }

void clear(Grid& grid) {
  for (std::size_t i = 0; i < grid.columns; ++i) {
    double* column = grid.at(i, 0);
    std::fill(column, column + grid.top[i] * Grid::width, 0.0);
    if (!grid.averages()) continue;
    double* spans = &grid.span[grid.index(i, 0) * 3];
    std::fill(spans, spans + grid.top[i] * 3, 0.0);
  }
}

}  // namespace leda::solver
