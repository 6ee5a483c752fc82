#pragma once
// The material points of a model, packed for the vector kernels.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "solver/kernel/points.hpp"

namespace leda::solver {

/// One bit for each lane of a pack.
using LaneBits = std::uint16_t;
static_assert(Pack<float>::lanes <= 16);

/// Where the first lane of a pack lives; also the home cell of a point.
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

template <class Real>
struct Packs {
  std::size_t count = 0;  ///< points
  bool held = false;      ///< points stay in their cells: nothing is in reserve
  bool moves = true;      ///< motion is kept; else `motion` is empty and stands for rest
  std::vector<Pack<Real>> pack;
  std::vector<PackPlace> place;
  std::vector<PackMotion<Real>> motion;
  std::vector<LaneBits> taken;    ///< lanes of the pack that hold a point
  std::vector<LaneBits> strayed;  ///< lanes whose point has left its home cell
  std::vector<PackGroup> group;
  std::vector<PackColumn> column;  ///< of the grid
};

/// Calls one(pack, lane) for every lane that holds a point.
template <class Real, class One>
void for_each_point(const Packs<Real>& packs, const One& one) {
  for (std::size_t i = 0; i < packs.pack.size(); ++i) {
    for (std::size_t l = 0; l < Pack<Real>::lanes; ++l) {
      if ((packs.taken[i] >> l & 1U) != 0) one(i, l);
    }
  }
}

/// Position of a lane from the grid's origin, m.
struct PointAt {
  double x, z;
};

template <class Real>
PointAt point_at(const Packs<Real>& packs, std::size_t pack, std::size_t lane, double h) {
  const PackPlace& place = packs.place[pack];
  const double row = place.row + static_cast<double>(lane % Pack<Real>::rows);
  return {(place.column - 0.5 + static_cast<double>(packs.pack[pack].x[lane])) * h,
          (row - 0.5 + static_cast<double>(packs.pack[pack].z[lane])) * h};
}

}  // namespace leda::solver
