// The scale is taken from the ellipsoid itself: a step along each axis of the map is turned into a
// step in longitude and latitude, and that into metres by the radii of curvature (Snyder 1987,
// Map projections: a working manual, eqs 4-22 to 4-27).

#include "profiles/ground_scale.hpp"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "profiles/dem.hpp"
#include "profiles/gdal_error.hpp"
#include "profiles/thread_cache.hpp"

namespace leda::profiles {
namespace {

constexpr double step_m = 10;

/// Metres east and north.
struct OnGround {
  double east = 0, north = 0;
  double length() const { return std::hypot(east, north); }
};

}  // namespace

struct GroundScale::Transformation {
  std::unique_ptr<OGRCoordinateTransformation> to_degrees;
  double metres_per_unit = 1;
  double radians_per_degree = 0;
  double semi_major_m = 0, eccentricity2 = 0;

  std::optional<MapPoint> geographic(MapPoint p) const {
    const QuietGdal quiet;
    if (to_degrees->Transform(1, &p.x, &p.y) == 0) return std::nullopt;
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return std::nullopt;
    return p;
  }

  /// Ground metres per map metre along a direction of length one.
  std::optional<OnGround> along(MapPoint p, MapPoint direction) const {
    const double step = step_m / metres_per_unit;
    const auto from = geographic({p.x - step * direction.x, p.y - step * direction.y});
    const auto to = geographic({p.x + step * direction.x, p.y + step * direction.y});
    if (!from || !to) return std::nullopt;
    const double sine = std::sin((from->y + to->y) / 2 * radians_per_degree);
    const double w2 = 1 - eccentricity2 * sine * sine;
    const double across_m = semi_major_m / std::sqrt(w2) * std::sqrt(1 - sine * sine);
    const double meridian_m = semi_major_m * (1 - eccentricity2) / (w2 * std::sqrt(w2));
    const double full_turn = 2 * std::numbers::pi;
    const double turn = std::remainder((to->x - from->x) * radians_per_degree, full_turn);
    return OnGround{across_m * turn / (2 * step_m),
                    meridian_m * (to->y - from->y) * radians_per_degree / (2 * step_m)};
  }
};

double Stretch::departure() const { return std::max(std::abs(least - 1), std::abs(most - 1)); }

GroundScale::GroundScale(int epsg) {
  initialize_gdal();
  auto& known = kept_by_thread<Transformation>(epsg);
  transformation_ = known;
  if (known) return;
  const QuietGdal quiet;
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.importFromEPSG(epsg) != OGRERR_NONE) return;
  const std::unique_ptr<OGRSpatialReference> geographic(crs.CloneGeogCS());
  if (!geographic) return;
  geographic->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  auto transformation = std::make_shared<Transformation>();
  transformation->to_degrees.reset(OGRCreateCoordinateTransformation(&crs, geographic.get()));
  if (!transformation->to_degrees) return;
  transformation->metres_per_unit = crs.GetLinearUnits();
  transformation->radians_per_degree = geographic->GetAngularUnits();
  transformation->semi_major_m = geographic->GetSemiMajor();
  const double inverse = geographic->GetInvFlattening();
  const double flattening = inverse > 0 ? 1 / inverse : 0;
  transformation->eccentricity2 = flattening * (2 - flattening);
  transformation_ = known = std::move(transformation);
}

GroundScale::~GroundScale() = default;
GroundScale::GroundScale(GroundScale&&) noexcept = default;
GroundScale& GroundScale::operator=(GroundScale&&) noexcept = default;

std::optional<std::array<double, 2>> GroundScale::along_axes(MapPoint p) const {
  if (!transformation_) return std::nullopt;
  const auto x = transformation_->along(p, {1, 0}), y = transformation_->along(p, {0, 1});
  if (!x || !y) return std::nullopt;
  return std::array{x->length(), y->length()};
}

// The singular values of the matrix whose columns are the two axes.
std::optional<Stretch> GroundScale::at(MapPoint p) const {
  if (!transformation_) return std::nullopt;
  const auto x = transformation_->along(p, {1, 0}), y = transformation_->along(p, {0, 1});
  if (!x || !y) return std::nullopt;
  const double sum =
      x->east * x->east + x->north * x->north + y->east * y->east + y->north * y->north;
  const double area = std::abs(x->east * y->north - x->north * y->east);
  const double rest = std::sqrt(std::max(0.0, sum * sum - 4 * area * area));
  return Stretch{std::sqrt(std::max(0.0, (sum - rest) / 2)), std::sqrt((sum + rest) / 2)};
}

std::string GroundScale::complaint_at(MapPoint p, double allowed) const {
  const auto stretch = at(p);
  if (!stretch || stretch->departure() <= allowed) return "";
  const auto where = transformation_->geographic(p).value_or(MapPoint{});
  const double to_degrees = transformation_->radians_per_degree * 180 / std::numbers::pi;
  const double longitude = std::remainder(where.x * to_degrees, 360.0);
  const int zone = std::clamp(static_cast<int>(std::floor((longitude + 180) / 6)) + 1, 1, 60);
  const int utm = (where.y < 0 ? 32700 : 32600) + zone;
  const std::string metres = stretch->most - stretch->least < 0.001
                                 ? fmt::format("{:.4g}", stretch->most)
                                 : fmt::format("{:.4g} to {:.4g}", stretch->least, stretch->most);
  return fmt::format(
      "1 m of the map is {} m on the ground, so that lengths and slopes would be wrong: reproject "
      "the DEM to a system made for this place, for example gdalwarp -t_srs EPSG:{} (UTM zone {})",
      metres, utm, zone);
}

}  // namespace leda::profiles
