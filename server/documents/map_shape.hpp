#pragma once
// Soundness of lines and rings on the map.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "profiles/map/coordinates.hpp"
#include "server/documents/object_reader.hpp"

namespace leda::server {

/// A list of [x, y] without repeated neighbours that neither crosses itself nor turns back on
/// itself. Faults otherwise, also where it has more than `most_points`.
MapLine read_map_line(const nlohmann::json& value, const std::string& at, std::size_t most_points,
                      FaultList& faults);

/// The same for a ring of at least three corners; closed when it comes back.
MapPolygon read_map_polygon(const nlohmann::json& value, const std::string& at,
                            std::size_t most_points, FaultList& faults);

/// One [x, y].
std::optional<MapPoint> read_map_point(const nlohmann::json& value, const std::string& at,
                                       FaultList& faults);

/// In units of the CRS.
double length_of(const MapLine& line);

}  // namespace leda::server
