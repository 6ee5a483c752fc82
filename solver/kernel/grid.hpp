#pragma once
// The background grid: sums and velocities by column, each value a run of memory.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/kernel/packs.hpp"

namespace leda::solver {

/// How large a grid is.
struct GridSize {
  double h = 0;             ///< side of a cell, m
  std::size_t columns = 0;  ///< of nodes, with both columns of ghost nodes
  std::size_t rows = 0;     ///< of nodes, with the ghost row at the base
};

/// Mass of a node, kg/m, below which there is only round-off: 1e-14 of one full of water.
constexpr double least_mass(double h) { return 1e-14 * 1000 * h * h; }

/// A grid over length x height (metres), whole cells.
GridSize grid_over(double h, double length, double height);

/// The plastic strain of a step on the nodes, on its way from points to points over a band
/// (solver/kernel/band.hpp). Empty where no band is averaged over.
template <class Real>
struct BandGrid {
  std::size_t passes = 0;  ///< of smoothing
  double share = 0;        ///< what a pass gives to each neighbour along an axis
  std::vector<Real> sums;  ///< sum w m (plastic strain), [columns][planes][stride]
  /// sum w m (plastic strain) and sum w m, [columns][stride], two arrays of each: a pass reads one
  /// and writes the other. The last one written holds the average in place of the sum.
  std::vector<Real> strain[2], mass[2];
  std::vector<std::uint8_t> active;  ///< columns within reach of ground that yielded

  bool exists() const { return !sums.empty(); }
  std::vector<Real>& average() { return strain[passes % 2]; }
};

/// Node (i, k) lies at ((i - 1) h, (k - 1) h) from the model's lower left corner: one layer of
/// ghost nodes lies outside the base and the sides. What points in home row k give to node row
/// k + j stands in plane j at k, so that a pack adds to aligned places that no other home row
/// touches; the three planes of a value are added up when the nodes are updated.
template <class Real>
struct Grid {
  /// What points give to nodes.
  enum Value : std::size_t { mass_sum, momentum_x, momentum_z, force_x, force_z, values };
  static constexpr std::size_t planes = 3;
  static constexpr std::size_t lead = 8;  ///< zeros below row 0

  double h = 0;
  std::size_t columns = 0, rows = 0;
  std::size_t stride = 0;        ///< of a plane
  std::vector<Real> sums;        ///< [columns][values][planes][stride]
  std::vector<Real> velocity;    ///< [columns][x z][stride]
  std::vector<std::size_t> top;  ///< rows in use in each column
  std::vector<Real> mass;        ///< [columns][stride] of the last update; empty where not kept
  std::vector<Real> force;       ///< [columns][x z][stride], unbalanced; empty where not kept
  /// Sums over the points of a span, the square h x h whose points see the same nine nodes,
  /// numbered by its lowest node: [columns][volume, mean of a value times volume][stride]. Empty:
  /// dilation is not averaged.
  std::vector<Real> span;
  bool shows_mass = false;  ///< points see the mass of the nodes
  BandGrid<Real> band;      ///< plastic strain averaged over a band

  bool averages() const { return !span.empty(); }
  /// Whether points take more from the nodes than their motion.
  bool shows_more() const { return shows_mass || band.exists(); }

  Real* sums_at(std::size_t column, std::size_t row) {
    return &sums[column * values * planes * stride + lead + row];
  }
  Real* velocity_at(std::size_t column, std::size_t row) {
    return &velocity[column * 2 * stride + lead + row];
  }
  Real* mass_at(std::size_t column, std::size_t row) { return &mass[column * stride + lead + row]; }
  Real* force_at(std::size_t column, std::size_t row) {
    return &force[column * 2 * stride + lead + row];
  }
  Real* span_at(std::size_t column, std::size_t row) {
    return &span[column * 2 * stride + lead + row];
  }
  Real* band_sums_at(std::size_t column, std::size_t row) {
    return &band.sums[column * planes * stride + lead + row];
  }
  /// Of an array [columns][stride].
  Real* at(std::vector<Real>& of, std::size_t column, std::size_t row) const {
    return &of[column * stride + lead + row];
  }
};

/// What a grid holds beside what every step needs.
struct GridExtras {
  bool mass = false;      ///< of the nodes, as points see it
  bool force = false;     ///< unbalanced, and its sums
  bool averages = false;  ///< dilation and mean stress are averaged over spans (B-bar)
  double band_m = 0;      ///< plastic strain is averaged over a band; 0: it is not
};

template <class Real>
Grid<Real> make_grid(const GridSize& size, const GridExtras& extras = {});

/// Groups of columns there are.
inline std::size_t groups_of(std::size_t columns) {
  return (columns + columns_of_a_group - 1) / columns_of_a_group;
}

}  // namespace leda::solver
