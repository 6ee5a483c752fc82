#pragma once
// Areas of the map through OGR and GEOS. Private to profiles/.

#include <vector>

#include "profiles/gdal_handle.hpp"
#include "profiles/map/coordinates.hpp"

namespace leda::profiles {

/// A polygon of OGR with closed rings.
GeometryHandle to_ogr(const MapPolygon& polygon);
/// Always a multipolygon, also of one.
GeometryHandle to_ogr(const std::vector<MapPolygon>& area);
GeometryHandle to_ogr(const MapLine& line);

/// The polygons of a geometry, whatever else it holds.
std::vector<MapPolygon> polygons_of(const OGRGeometry& geometry);

/// The union of rings that may cross themselves and each other, as valid polygons; parts smaller
/// than `least_area` (units of the CRS, squared) are dropped.
/// @throws std::runtime_error where GEOS fails
std::vector<MapPolygon> union_of(const std::vector<MapLine>& rings, double least_area);

/// The union of valid polygons. @throws std::runtime_error where GEOS fails
std::vector<MapPolygon> union_of(const std::vector<MapPolygon>& polygons);

}  // namespace leda::profiles
