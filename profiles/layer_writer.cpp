#include "profiles/layer_writer.hpp"

#include <cpl_string.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <ctime>

#include "profiles/areas.hpp"
#include "profiles/dbf_text.hpp"
#include "profiles/gdal_error.hpp"
#include "profiles/layer_columns.hpp"
#include "profiles/map_geometry.hpp"
#include "profiles/qgis_style.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

struct Target {
  OGRLayer* layer = nullptr;
  bool short_names = false;
};

[[noreturn]] void fail(const std::string& what) { throw ExportError(what + gdal_message()); }

DatasetHandle create(const char* driver_name, const fs::path& file) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
  DatasetHandle dataset(driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!dataset) fail("can't create " + file.string());
  return dataset;
}

OGRSpatialReference crs_of(int epsg) {
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.importFromEPSG(epsg) != OGRERR_NONE) {
    fail("EPSG:" + std::to_string(epsg) + " is not known");
  }
  return crs;
}

template <class Row>
void add_fields(Target target, const std::vector<Column<Row>>& columns) {
  for (const Column<Row>& column : columns) {
    const char* name = target.short_names ? column.short_name : column.name;
    if (target.layer->GetLayerDefn()->GetFieldIndex(name) >= 0) continue;
    OGRFieldDefn field(name, column.type);
    if (target.layer->CreateField(&field) != OGRERR_NONE) fail(std::string("field ") + name);
  }
}

// A layer without a value has null in every field, so that readers see the same fields everywhere.
template <class Row>
void add_row(Target target, const std::vector<Column<Row>>& columns, const Row& row,
             GeometryHandle geometry, const char* layer_name = nullptr) {
  OGRFeature feature(target.layer->GetLayerDefn());
  for (const Column<Row>& column : columns) {
    const char* name = target.short_names ? column.short_name : column.name;
    column.set(feature, feature.GetFieldIndex(name), row);
  }
  if (layer_name) feature.SetField("layer", layer_name);
  for (int i = 0; i < feature.GetFieldCount(); ++i) {
    if (!feature.IsFieldSet(i)) feature.SetFieldNull(i);
  }
  feature.SetGeometryDirectly(geometry.release());
  if (target.layer->CreateFeature(&feature) != OGRERR_NONE) fail("can't write a feature");
}

void add_ground(Target target, const std::vector<Column<ProfilePoint>>& columns,
                const SectionFeature& section, const Polyline& ground, const char* stage) {
  if (section.ground_before.size() < 2) return;
  const double start = section.ground_before.front().x;
  const double span = section.ground_before.back().x - start;
  const double length = length_of(section.trace);
  for (const Point& p : ground) {
    const MapPoint where = point_at(section.trace, (p.x - start) / span * length);
    auto point = std::make_unique<OGRPoint>(where.x, where.y, p.z);
    add_row(target, columns, ProfilePoint{&section, stage, p.x, p.z, where},
            GeometryHandle(point.release()));
  }
}

bool has_ensemble(const RegionLayers& layers) {
  return std::ranges::any_of(layers.zones,
                             [](const Zone& zone) { return zone.probability.has_value(); });
}

std::vector<ZoneRow> rows_of(const RegionLayers& layers, const std::string& layer) {
  const double unit = crs_of(layers.epsg).GetLinearUnits();
  std::vector<ZoneRow> rows;
  for (const Zone& zone : layers.zones) {
    if (layer != to_string(layer_of(zone))) continue;
    const GeometryHandle area = to_ogr(zone.area);
    rows.push_back({&zone, area->toMultiPolygon()->get_Area() * unit * unit});
  }
  return rows;
}

void fill_layer(Target target, const RegionLayers& layers, const std::string& name) {
  const std::size_t most_bytes = target.short_names ? most_dbf_bytes : any_length;
  if (name == "sections") {
    const auto columns = section_columns(layers, most_bytes);
    add_fields(target, columns);
    for (const SectionFeature& s : layers.sections) add_row(target, columns, s, to_ogr(s.trace));
  } else if (name == "profiles") {
    const auto columns = profile_columns(layers);
    add_fields(target, columns);
    for (const SectionFeature& s : layers.sections) {
      add_ground(target, columns, s, s.ground_before, "before");
      add_ground(target, columns, s, s.ground_after, "after");
    }
  } else {
    const auto columns =
        zone_columns(layers, name == to_string(ZoneLayer::probability), most_bytes);
    add_fields(target, columns);
    for (const ZoneRow& row : rows_of(layers, name)) {
      add_row(target, columns, row, to_ogr(row.zone->area));
    }
  }
}

OGRwkbGeometryType geometry_of(const std::string& layer) {
  if (layer == "sections") return wkbLineString;
  return layer == "profiles" ? wkbPoint25D : wkbMultiPolygon;
}

void write_layer(GDALDataset& dataset, const RegionLayers& layers, const std::string& name,
                 bool short_names) {
  OGRSpatialReference crs = crs_of(layers.epsg);
  CPLStringList how;
  if (std::string(dataset.GetDriverName()) == "ESRI Shapefile") {
    how.SetNameValue("ENCODING", "UTF-8");
    if (name == "profiles") how.SetNameValue("SHPT", "POINTZ");
  }
  OGRLayer* layer = dataset.CreateLayer(name.c_str(), &crs, geometry_of(name), how.List());
  if (!layer) fail("can't create the layer " + name);
  fill_layer({layer, short_names}, layers, name);
}

// The table QGIS looks for; GDAL registers it in gpkg_contents as `attributes`.
void write_styles(GDALDataset& dataset, const RegionLayers& layers) {
  CPLStringList how;
  how.SetNameValue("FID", "id");
  OGRLayer* layer = dataset.CreateLayer("layer_styles", nullptr, wkbNone, how.List());
  if (!layer) fail("can't create layer_styles");
  for (const char* name : {"f_table_catalog", "f_table_schema", "f_table_name", "f_geometry_column",
                           "styleName", "styleQML", "styleSLD"}) {
    OGRFieldDefn field(name, OFTString);
    layer->CreateField(&field);
  }
  OGRFieldDefn by_default("useAsDefault", OFTInteger);
  by_default.SetSubType(OFSTBoolean);
  layer->CreateField(&by_default);
  for (const char* name : {"description", "owner", "ui"}) {
    OGRFieldDefn field(name, OFTString);
    layer->CreateField(&field);
  }
  OGRFieldDefn updated("update_time", OFTDateTime);
  layer->CreateField(&updated);
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  for (const std::string& name : layers_of(layers)) {
    OGRFeature style(layer->GetLayerDefn());
    for (const char* empty : {"f_table_catalog", "f_table_schema", "styleSLD", "owner", "ui"}) {
      style.SetField(empty, "");
    }
    style.SetField("f_table_name", name.c_str());
    style.SetField("f_geometry_column", "geom");
    style.SetField("styleName", "Leda");
    style.SetField("styleQML", qgis_style(name, layers.zones).c_str());
    style.SetField("useAsDefault", 1);
    style.SetField("description", "Leda's style of this layer");
    style.SetField("update_time", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday, utc.tm_hour,
                   utc.tm_min, static_cast<float>(utc.tm_sec), 100);
    if (layer->CreateFeature(&style) != OGRERR_NONE) fail("can't write a style");
  }
}

RegionLayers in_crs84(const RegionLayers& layers) {
  const ToCrs84 to_crs84(layers.epsg);
  RegionLayers result = layers;
  result.epsg = 4326;
  for (SectionFeature& s : result.sections) s.trace = to_crs84(s.trace);
  for (Zone& zone : result.zones) {
    for (MapPolygon& polygon : zone.area) polygon = to_crs84(polygon);
  }
  return result;
}

// A failed flush at the end (a full disk) is only told by the last error.
void close(DatasetHandle dataset, const fs::path& file) {
  CPLErrorReset();
  dataset->FlushCache();
  dataset.reset();
  if (CPLGetLastErrorType() >= CE_Failure) fail("can't write " + file.string());
}

}  // namespace

std::vector<std::string> layers_of(const RegionLayers& layers) {
  std::vector<std::string> names{"sections", "profiles", to_string(ZoneLayer::release),
                                 to_string(ZoneLayer::runout)};
  if (has_ensemble(layers)) names.emplace_back(to_string(ZoneLayer::probability));
  return names;
}

void write_geopackage(const RegionLayers& layers, const fs::path& file) {
  DatasetHandle dataset = create("GPKG", file);
  if (dataset->StartTransaction() != OGRERR_NONE) fail("can't write " + file.string());
  for (const std::string& name : layers_of(layers)) write_layer(*dataset, layers, name, false);
  write_styles(*dataset, layers);
  if (dataset->CommitTransaction() != OGRERR_NONE) fail("can't write " + file.string());
  close(std::move(dataset), file);
}

void write_geojson(const RegionLayers& layers, const fs::path& file) {
  const RegionLayers world = in_crs84(layers);
  DatasetHandle dataset = create("GeoJSON", file);
  OGRSpatialReference crs = crs_of(4326);
  CPLStringList how;
  how.SetNameValue("RFC7946", "YES");
  OGRLayer* layer = dataset->CreateLayer("leda", &crs, wkbUnknown, how.List());
  if (!layer) fail("can't create the layer");
  const Target target{layer, false};
  OGRFieldDefn which("layer", OFTString);
  layer->CreateField(&which);
  const auto of_sections = section_columns(world);
  const auto of_zones = zone_columns(world, has_ensemble(world));
  add_fields(target, of_sections);
  add_fields(target, of_zones);
  for (const SectionFeature& s : world.sections) {
    add_row(target, of_sections, s, to_ogr(s.trace), "sections");
  }
  for (const ZoneLayer of : all_zone_layers) {
    const char* name = to_string(of);
    std::vector<ZoneRow> areas = rows_of(layers, name);  // measured in the native CRS
    std::vector<ZoneRow> rows = rows_of(world, name);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].area_m2 = areas[i].area_m2;
      add_row(target, of_zones, rows[i], to_ogr(rows[i].zone->area), name);
    }
  }
  close(std::move(dataset), file);
}

void write_layer_files(const RegionLayers& layers, const std::string& ending,
                       const fs::path& folder) {
  const bool shapefile = ending == "shp";
  for (const std::string& name : layers_of(layers)) {
    const fs::path file = folder / (name + "." + ending);
    DatasetHandle dataset = create(shapefile ? "ESRI Shapefile" : "FlatGeobuf", file);
    write_layer(*dataset, layers, name, shapefile);
    close(std::move(dataset), file);
  }
}

}  // namespace leda::profiles
