#pragma once
// The packs of one group of columns, made anew.

#include <vector>

#include "solver/kernel/grid.hpp"
#include "solver/kernel/packed_point.hpp"

namespace leda::solver {

/// Packs that a group may have in use before it is made anew, where `in_order` are the fewest: with
/// more in reserve, packs are made anew less often and hold fewer points.
constexpr std::size_t most_in_use(std::size_t in_order) { return in_order + in_order / 6 + 1; }

/// Groups without packs.
template <class Real>
void begin_groups(Packs<Real>& packs, const Grid<Real>& grid);

/// Makes room for so many packs in group g; the new ones are empty.
template <class Real>
void make_room(Packs<Real>& packs, std::size_t g, std::size_t room);

/// Sets the rows in use of every column of the grid.
template <class Real>
void set_all_tops(const Packs<Real>& packs, Grid<Real>& grid);

/// Makes the fewest packs that hold these points, in the order given, and some in reserve, in place
/// of what group g held; sets the tops of the grid.
/// @pre the points' homes are columns of the group
template <class Real>
void fill_group(Packs<Real>& packs, Grid<Real>& grid, std::size_t g,
                const std::vector<PointAtHome<Real>>& points);

/// Makes sure that the grid has rows in use for a point of this home.
template <class Real>
void raise_tops(Packs<Real>& packs, Grid<Real>& grid, const PackPlace& home);

}  // namespace leda::solver
