#pragma once
// The background grid: nodes on squares of side h, columns of nodes contiguous in memory.

#include <cstddef>
#include <vector>

namespace leda::solver {

/// Node (i, k) lies at ((i - 1) h, (k - 1) h) from the model's lower left corner: one layer of
/// image nodes lies outside the base and the sides (see boundary.hpp). All of a node's values
/// stand side by side, so that the three nodes a particle sees in one column are one run of
/// memory.
struct Grid {
  static constexpr std::size_t width = 5;  ///< mass, momentum x z, force x z

  double h = 0;
  std::size_t columns = 0;       ///< with both image columns
  std::size_t rows = 0;          ///< with the image row at the base
  std::vector<double> node;      ///< [columns][rows][width] and padding
  std::vector<double> velocity;  ///< [columns][rows][2] and padding, after the step
  std::vector<std::size_t> top;  ///< rows in use in each column, set when particles are sorted
  /// Sums over the particles of a span, the square h x h that sees the same nine nodes, numbered
  /// by its lowest node: [columns][rows][3] volume, pressure, dilation. Empty: nothing is averaged.
  std::vector<double> span;

  bool averages() const { return !span.empty(); }
  std::size_t index(std::size_t column, std::size_t row) const { return column * rows + row; }
  double* at(std::size_t column, std::size_t row) { return &node[index(column, row) * width]; }
};

/// A grid over length x height (metres), whole cells, with room above.
Grid make_grid(double h, double length, double height);

/// From here on dilation and pressure are averaged over each span (solver/README.md, "Nearly
/// incompressible ground").
void average_spans(Grid& grid);

/// Sets the nodes and spans in use to zero.
void clear(Grid& grid);

}  // namespace leda::solver
