#include "profiles/areas.hpp"

#include <stdexcept>

#include "profiles/gdal_error.hpp"

namespace leda::profiles {
namespace {

void add_ring(OGRPolygon& polygon, const MapLine& points) {
  auto ring = std::make_unique<OGRLinearRing>();
  for (const MapPoint& p : points) ring->addPoint(p.x, p.y);
  ring->closeRings();
  polygon.addRingDirectly(ring.release());
}

MapLine to_line(const OGRLinearRing& ring) {
  MapLine line;
  for (int i = 0; i < ring.getNumPoints(); ++i) line.push_back({ring.getX(i), ring.getY(i)});
  return line;
}

// Polygons among whatever GEOS gave back: mending a ring may leave lines and points behind.
void collect(const OGRGeometry& geometry, double least_area, std::vector<MapPolygon>& area) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    const OGRPolygon& polygon = *geometry.toPolygon();
    if ((polygon.IsEmpty() != 0) || polygon.get_Area() < least_area) return;
    MapPolygon part{to_line(*polygon.getExteriorRing()), {}};
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i) {
      part.holes.push_back(to_line(*polygon.getInteriorRing(i)));
    }
    area.push_back(std::move(part));
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection) != 0) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) {
      collect(*part, least_area, area);
    }
  }
}

std::vector<MapPolygon> joined(const OGRMultiPolygon& pieces, double least_area) {
  std::vector<MapPolygon> area;
  if (pieces.IsEmpty() != 0) return area;
  const GeometryHandle united(pieces.UnionCascaded());
  if (!united) throw std::runtime_error("GEOS can't join a zone" + gdal_message());
  collect(*united, least_area, area);
  return area;
}

}  // namespace

GeometryHandle to_ogr(const MapPolygon& polygon) {
  auto result = std::make_unique<OGRPolygon>();
  add_ring(*result, polygon.outer);
  for (const MapLine& hole : polygon.holes) add_ring(*result, hole);
  return GeometryHandle(result.release());
}

GeometryHandle to_ogr(const std::vector<MapPolygon>& area) {
  auto result = std::make_unique<OGRMultiPolygon>();
  for (const MapPolygon& polygon : area) result->addGeometryDirectly(to_ogr(polygon).release());
  return GeometryHandle(result.release());
}

GeometryHandle to_ogr(const MapLine& line) {
  auto result = std::make_unique<OGRLineString>();
  for (const MapPoint& p : line) result->addPoint(p.x, p.y);
  return GeometryHandle(result.release());
}

std::vector<MapPolygon> polygons_of(const OGRGeometry& geometry) {
  std::vector<MapPolygon> polygons;
  collect(geometry, 0, polygons);
  return polygons;
}

std::vector<MapPolygon> union_of(const std::vector<MapLine>& rings, double least_area) {
  const QuietGdal quiet;
  OGRMultiPolygon pieces;
  for (const MapLine& ring : rings) {
    const GeometryHandle sound(to_ogr(MapPolygon{ring, {}})->MakeValid());
    if (!sound) throw std::runtime_error("GEOS can't mend a zone" + gdal_message());
    std::vector<MapPolygon> parts;
    collect(*sound, 0, parts);
    for (const MapPolygon& part : parts) pieces.addGeometryDirectly(to_ogr(part).release());
  }
  return joined(pieces, least_area);
}

std::vector<MapPolygon> union_of(const std::vector<MapPolygon>& polygons) {
  const QuietGdal quiet;
  return joined(*to_ogr(polygons)->toMultiPolygon(), 0);
}

}  // namespace leda::profiles
