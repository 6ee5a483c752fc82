#pragma once
// Bishop's simplified method (1955): moments about the centre, vertical forces of each slice.

#include <vector>

#include "solver/screening/slip_surface.hpp"

namespace leda::solver {

/// F = sum[(c l + (N - u l) tan phi) R] / sum[W a + N f], with
/// N = (W - (c l - u l tan phi) sin a / F) / (cos a + sin a tan phi / F).
/// R, a and f are the arms of shear, weight and normal force: on an arc f = 0 and R is the radius;
/// where the surface follows a layer this is the extension of Fredlund and Krahn (1977) to
/// composite surfaces.
/// @return infinity where no weight drives or the method has no solution on this surface
double bishop(const std::vector<Slice>& slices);

/// phi = 0 on a whole arc: no normal and no interslice force has a moment about the centre, so
/// that the factor is one division and the same by every method that balances moments.
bool is_frictionless_arc(const std::vector<Slice>& slices);

}  // namespace leda::solver
