#include <ogr_spatialref.h>

#include <algorithm>
#include <memory>

#include "profiles/dem.hpp"
#include "profiles/export_layers.hpp"
#include "profiles/gdal_error.hpp"
#include "profiles/thread_cache.hpp"

namespace leda::profiles {
namespace {

double signed_area(const MapLine& ring) {
  double twice = 0;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    // From the first point: coordinates far from zero would drown the area in rounding.
    const double ax = ring[i - 1].x - ring[0].x, ay = ring[i - 1].y - ring[0].y;
    const double bx = ring[i].x - ring[0].x, by = ring[i].y - ring[0].y;
    twice += ax * by - bx * ay;
  }
  return twice / 2;
}

MapLine turning(MapLine ring, bool counter_clockwise) {
  if ((signed_area(ring) > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  return ring;
}

}  // namespace

struct ToCrs84::Transformation {
  std::unique_ptr<OGRCoordinateTransformation> transform;
};

std::shared_ptr<const ToCrs84::Transformation> ToCrs84::known(int epsg) {
  auto& found = kept_by_thread<Transformation>(epsg);
  if (found) return found;
  auto transformation = std::make_shared<Transformation>();
  OGRSpatialReference from, to;
  from.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  to.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (from.importFromEPSG(epsg) == OGRERR_NONE && to.importFromEPSG(4326) == OGRERR_NONE) {
    transformation->transform.reset(OGRCreateCoordinateTransformation(&from, &to));
  }
  if (transformation->transform) found = std::move(transformation);
  return found;
}

ToCrs84::ToCrs84(int epsg) {
  initialize_gdal();
  const QuietGdal quiet;
  transformation_ = known(epsg);
  if (!transformation_) {
    throw ExportError("EPSG:" + std::to_string(epsg) + " can't be turned into CRS84" +
                      gdal_message());
  }
}

ToCrs84::~ToCrs84() = default;
ToCrs84::ToCrs84(ToCrs84&&) noexcept = default;
ToCrs84& ToCrs84::operator=(ToCrs84&&) noexcept = default;

MapPoint ToCrs84::operator()(MapPoint p) const {
  const QuietGdal quiet;
  if (transformation_->transform->Transform(1, &p.x, &p.y) == 0) {
    throw ExportError("a point lies outside what its coordinate system covers" + gdal_message());
  }
  return p;
}

MapLine ToCrs84::operator()(const MapLine& line) const {
  MapLine result;
  result.reserve(line.size());
  for (const MapPoint& p : line) result.push_back((*this)(p));
  return result;
}

MapPolygon ToCrs84::operator()(const MapPolygon& polygon) const {
  MapPolygon result{turning((*this)(polygon.outer), true), {}};
  for (const MapLine& hole : polygon.holes) result.holes.push_back(turning((*this)(hole), false));
  return result;
}

}  // namespace leda::profiles
