#pragma once
// Material points of a moving run, packed for the vector kernels.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/kernel/grid.hpp"
#include "solver/kernel/particles.hpp"
#include "solver/materials/law_table.hpp"

namespace leda::solver {

/// Single precision: positions are kept within their cell, plastic strain is summed with its
/// rounding error, energies are summed in double. What it changes: solver/kernel/README.md.
using Real = float;

/// Two material points in each of eight rows of one column of home cells: lane l lives in row
/// `row + l % rows`. The home cell of a point is that of the lowest node it sees, when it was last
/// put there; so the nodes that eight lanes see are runs of memory, nothing is gathered or
/// scattered, and both points of a row share what is read and summed. Lanes without a point have no
/// mass and no volume.
struct alignas(64) Pack {
  static constexpr std::size_t rows = 8;
  static constexpr std::size_t lanes = 2 * rows;

  Real x[lanes], z[lanes];  ///< from the home cell's lower left corner, in cells
  Real sxx[lanes], szz[lanes], sxz[lanes], syy[lanes];  ///< Cauchy stress, Pa
  Real mass[lanes];                                     ///< kg per metre of width
  Real volume[lanes];                                   ///< m3 per metre of width
  Real plastic_strain[lanes];                           ///< engineering shear strain
  Real plastic_rest[lanes];                             ///< what rounding took from it (Kahan)
  std::int32_t law[lanes];                              ///< row of the law table
  std::int32_t particle[lanes];                         ///< place in Particles; -1: no point
};

/// Velocity and its gradient at the points of a pack: written only in steps after which somebody
/// looks, since the step itself passes them on in registers.
struct alignas(64) PackMotion {
  Real vx[Pack::lanes], vz[Pack::lanes];  ///< m/s
  /// Times the cell, m/s (see Particles::cxx).
  Real cxx[Pack::lanes], cxz[Pack::lanes], czx[Pack::lanes], czz[Pack::lanes];
};

/// One bit for each lane of a pack.
using LaneBits = std::uint16_t;
static_assert(Pack::lanes <= 16);

/// Where the first lane of a pack lives.
struct PackPlace {
  std::uint32_t column, row;
};

/// Columns that are worked on as one. The order of sums is that of the groups, even ones before odd
/// ones, however many threads there are.
inline constexpr std::size_t columns_of_a_group = 16;

/// The packs of one group of columns. What they give to the nodes touches the group's neighbours
/// and no group beyond.
struct PackGroup {
  std::size_t first = 0;     ///< pack
  std::size_t room = 0;      ///< packs, those in use before those in reserve, which are empty
  std::size_t in_use = 0;    ///< packs, the first of them in the order of their columns
  std::size_t in_order = 0;  ///< packs
  std::size_t points = 0;

  std::size_t end() const { return first + in_use; }
};

/// The packs in order of a column, counted from its group's first, and the rows its points reach.
struct PackColumn {
  std::uint32_t first = 0, rows = 0;
};

struct Packs {
  std::size_t count = 0;  ///< points
  std::vector<Pack> pack;
  std::vector<PackPlace> place;
  std::vector<PackMotion> motion;
  std::vector<LaneBits> taken;    ///< lanes of the pack that hold a point
  std::vector<LaneBits> strayed;  ///< lanes whose point has left its home cell
  std::vector<PackGroup> group;
  std::vector<PackColumn> column;  ///< of the grid
};

/// The law table in single precision, without rate and flow. Columns go on with zeros for
/// `2 * Pack::lanes`, so that two vectors can be read from any row on.
struct PackLaws {
  std::size_t rows = 0;  ///< without the filling
  std::vector<Real> bulk, shear, peak;
  std::vector<Real> floor, amplitude, rate, exp_end, line_start, line_slope, line_end, last;
  /// Whether ground that would limit the time step of all of it gets lower moduli: `thin` and
  /// `strained` (solver/kernel/softer-inl.hpp).
  bool softer = false;
};

PackLaws pack_laws(const LawTable& table, bool softer);

}  // namespace leda::solver
