#pragma once
// Lines as lists of points.

#include <nlohmann/json_fwd.hpp>

#include "profiles/map/coordinates.hpp"
#include "solver/section/geometry.hpp"

namespace leda::server {

using Rounding = double (*)(double);

constexpr double as_it_is(double value) { return value; }

/// [[x, y], ...]
nlohmann::json points(const MapLine& line, Rounding rounded = as_it_is);
/// [[x, z], ...]
nlohmann::json points(const Polyline& line);

}  // namespace leda::server
