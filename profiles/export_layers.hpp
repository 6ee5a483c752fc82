#pragma once
// Sections, profiles and zones to files that GIS programs open.

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"
#include "profiles/map/zone.hpp"
#include "solver/section/geometry.hpp"

namespace leda::profiles {

class ExportError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct SectionFeature {
  std::string name;
  int line = -1;
  double order = 0;  ///< m
  MapLine trace;
  std::string status;    ///< the run's status, else the section's state ("left-out", "stable", ...)
  std::string decision;  ///< of screening; may be empty
  std::string reason;
  std::optional<double> factor_of_safety;  ///< of screening: undrained, Bishop
  std::optional<double> stability_number;  ///< of screening
  std::optional<double> retrogression_m, runout_m, runout_from_crest_m;
  std::optional<std::string> retrogression_is, runout_is;  ///< "measured" or "lower-bound"
  std::optional<int> slides;
  std::optional<double> simulated_s, run_time_s;
  std::optional<MapPoint> crest, toe, backscarp, front;
  Polyline ground_before;  ///< x along the trace, m; both empty where there is none
  Polyline ground_after;
  std::vector<std::string> warnings;
  std::string made_by;
};

struct RegionLayers {
  std::string name;
  std::string job;
  int epsg = 0;
  std::vector<SectionFeature> sections;
  std::vector<Zone> zones;
};

enum class ExportFormat {
  geopackage,  ///< native CRS; layers sections, profiles, release_zones, runout_zones, with styles
  geojson,     ///< CRS84 (RFC 7946), one collection; the property `layer` names the layer
  shapefile,   ///< a zip of one shapefile a layer, native CRS
  flatgeobuf   ///< a zip of one file a layer, native CRS
};

inline constexpr std::array all_export_formats{ExportFormat::geopackage, ExportFormat::geojson,
                                               ExportFormat::shapefile, ExportFormat::flatgeobuf};

/// "gpkg", "geojson", "shp", "fgb"
std::optional<ExportFormat> export_format_from(const std::string& text);
/// ".gpkg", ".geojson", ".shp.zip", ".fgb.zip"
const char* file_ending(ExportFormat format);
/// The media type to serve the file with.
const char* media_type(ExportFormat format);

/// Writes under a temporary name beside `file`, then renames over it.
/// Results stand in fields `leda_*`; an official hazard class is never assigned.
/// @throws ExportError naming the file
void export_layers(const RegionLayers& layers, ExportFormat format,
                   const std::filesystem::path& file);

/// From the coordinates of a CRS to longitude and latitude (CRS84), for OGC API - Features.
/// Belongs to the thread that made it.
class ToCrs84 {
 public:
  /// @throws ExportError where PROJ does not know the code
  explicit ToCrs84(int epsg);
  ~ToCrs84();
  ToCrs84(const ToCrs84&) = delete;
  ToCrs84& operator=(const ToCrs84&) = delete;
  ToCrs84(ToCrs84&& other) noexcept;
  ToCrs84& operator=(ToCrs84&& other) noexcept;

  MapPoint operator()(MapPoint p) const;
  MapLine operator()(const MapLine& line) const;
  /// Rings as RFC 7946 wants them: outer counter-clockwise, holes clockwise.
  MapPolygon operator()(const MapPolygon& polygon) const;

 private:
  struct Transformation;
  static std::shared_ptr<const Transformation> known(int epsg);
  std::shared_ptr<const Transformation> transformation_;
};

}  // namespace leda::profiles
