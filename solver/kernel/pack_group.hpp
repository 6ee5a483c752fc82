#pragma once
// The packs of one group of columns, made anew.

#include <vector>

#include "solver/kernel/pack_grid.hpp"
#include "solver/kernel/packed_point.hpp"

namespace leda::solver {

/// Packs that a group may have in use before it is made anew, where `in_order` are the fewest: with
/// more in reserve, packs are made anew less often and hold fewer points.
constexpr std::size_t most_in_use(std::size_t in_order) { return in_order + in_order / 6 + 1; }

/// Groups without packs.
void begin_groups(Packs& packs, const PackGrid& grid);

/// Makes the fewest packs that hold these points, in the order given, and some in reserve, in place
/// of what group g held; sets the tops of the grid. Points have no motion.
/// @pre the points' homes are columns of the group
void fill_group(Packs& packs, PackGrid& grid, std::size_t g,
                const std::vector<PointAtHome>& points);

/// Makes the rows of a cell's points part of the grid in use, with one to spare upwards and
/// sideways.
void raise_tops(Packs& packs, PackGrid& grid, const PackPlace& home);

}  // namespace leda::solver
