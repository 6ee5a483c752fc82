#pragma once
// What stands above a point of the ground.

#include "solver/section/section.hpp"

namespace leda {

/// Weight of the layers above a point, Pa, compression positive.
double overburden(const Section& section, Point p);

}  // namespace leda
