#pragma once
// Geometry and warnings as the JSON text of a column. Private to db/.
// Numbers come back bit for bit; NaN and infinity, which JSON lacks, come back as NaN.

#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"
#include "solver/section/geometry.hpp"

namespace leda::db {

std::string to_json(const Polyline& line);                   ///< [[x, z], ...]
std::string to_json(const MapLine& line);                    ///< [[x, y], ...]
std::string to_json(const std::vector<MapPolygon>& area);    ///< MultiPolygon coordinates
std::string to_json(const std::vector<std::string>& words);  ///< ["...", ...]

Polyline polyline_from_json(const std::string& text);
MapLine map_line_from_json(const std::string& text);
std::vector<MapPolygon> area_from_json(const std::string& text);
std::vector<std::string> words_from_json(const std::string& text);

}  // namespace leda::db
