#pragma once
// The surface of packed ground, without unpacking it.

#include "solver/observe.hpp"
#include "solver/packs/pack_grid.hpp"
#include "solver/packs/packs.hpp"

namespace leda::solver {

/// surface() of the particles that the packs hold; `seeded` gives origin and spacing.
Surface packed_surface(const Packs& packs, const PackGrid& grid, const Seeded& seeded);

}  // namespace leda::solver
