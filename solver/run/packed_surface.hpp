#pragma once
// The surface of packed ground, without unpacking it.

#include "solver/kernel/pack_grid.hpp"
#include "solver/kernel/packs.hpp"
#include "solver/run/observe.hpp"

namespace leda::solver {

/// surface() of the particles that the packs hold; `seeded` gives origin and spacing.
Surface packed_surface(const Packs& packs, const PackGrid& grid, const Seeded& seeded);

}  // namespace leda::solver
