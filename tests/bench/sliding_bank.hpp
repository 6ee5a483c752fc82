#pragma once
// The bank the benchmarks of the solver step.

#include "solver/seed_particles.hpp"

namespace leda::solver::bench {

/// A bank like Sainte-Monique's (thesis, chapter 4) at cells of 1 m: 17 m high over 5 m of the same
/// clay, 150 m of plateau, 60 m of floor. `seconds` after softening is on; 0: at rest.
Seeded bank_after(double seconds);

}  // namespace leda::solver::bench
