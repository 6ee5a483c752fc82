#include "profiles/export_layers.hpp"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <fstream>
#include <sstream>

#include "profiles/dem.hpp"
#include "profiles/gdal_handle.hpp"
#include "tests/profiles/drawn_dem.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;
using test::TestFolder;

RegionLayers region() {
  RegionLayers layers;
  layers.name = "a reach";
  layers.job = "job-1";
  layers.epsg = 2950;
  SectionFeature slid;
  slid.name = "AA'";
  slid.trace = {{380500, 5113500}, {380500, 5113194}};
  slid.status = "at-rest";
  slid.retrogression_m = 103.25;
  slid.runout_m = 21.5;
  slid.slides = 5;
  slid.run_time_s = 12.5;
  slid.ground_before = {{0, 21.7}, {183, 21.7}, {220, 5}, {306, 5}};
  slid.ground_after = {{0, 21.7}, {80, 21.7}, {90, 12}, {306, 5}};
  slid.warnings = {"one", "two"};
  slid.made_by = "abc";
  SectionFeature left_out;
  left_out.name = "S001";
  left_out.line = 0;
  left_out.trace = {{380600, 5113500}, {380600, 5113194}};
  left_out.status = "left-out";
  left_out.reason = "no data <at> \"the\" toe & beyond";
  layers.sections = {slid, left_out};
  for (const ZoneKind kind : {ZoneKind::release, ZoneKind::runout}) {
    Zone zone;
    zone.kind = kind;
    const double y = kind == ZoneKind::release ? 5113280 : 5113230;
    zone.area = {{{{380490, y}, {380490, y + 50}, {380510, y + 50}, {380510, y}, {380490, y}}, {}}};
    zone.sections = {"AA'"};
    zone.largest_distance_m = zone.mean_distance_m = 103.25;
    zone.warnings = {"AA': one"};
    zone.made_by = "def";
    layers.zones.push_back(zone);
  }
  return layers;
}

DatasetHandle open_vector(const std::string& file) {
  return DatasetHandle(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR));
}

std::string text_of(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(ExportLayers, GeoPackageHoldsEveryLayerInTheNativeCrs) {
  const TestFolder folder;
  export_layers(region(), ExportFormat::geopackage, folder / "out.gpkg");
  const DatasetHandle gpkg = open_vector(folder / "out.gpkg");
  ASSERT_TRUE(gpkg);
  const std::pair<const char*, int> counts[] = {
      {"sections", 2}, {"profiles", 8}, {"release_zones", 1}, {"runout_zones", 1}};
  for (const auto& [name, count] : counts) {
    OGRLayer* layer = gpkg->GetLayerByName(name);
    ASSERT_NE(layer, nullptr) << name;
    EXPECT_EQ(layer->GetFeatureCount(), count) << name;
    EXPECT_STREQ(layer->GetSpatialRef()->GetAuthorityCode(nullptr), "2950") << name;
  }
  std::unique_ptr<OGRFeature> section(gpkg->GetLayerByName("sections")->GetFeature(1));
  EXPECT_STREQ(section->GetFieldAsString("name"), "AA'");
  EXPECT_STREQ(section->GetFieldAsString("leda_status"), "at-rest");
  EXPECT_DOUBLE_EQ(section->GetFieldAsDouble("leda_retrogression_m"), 103.25);
  EXPECT_STREQ(section->GetFieldAsString("leda_warnings"), "one; two");
  std::unique_ptr<OGRFeature> left_out(gpkg->GetLayerByName("sections")->GetFeature(2));
  EXPECT_TRUE(left_out->IsFieldNull(left_out->GetFieldIndex("leda_retrogression_m")));
  EXPECT_STREQ(left_out->GetFieldAsString("leda_reason"), "no data <at> \"the\" toe & beyond");
  std::unique_ptr<OGRFeature> zone(gpkg->GetLayerByName("release_zones")->GetFeature(1));
  EXPECT_DOUBLE_EQ(zone->GetFieldAsDouble("leda_area_m2"), 1000);
  EXPECT_TRUE(zone->GetGeometryRef()->IsValid());
  EXPECT_EQ(wkbFlatten(zone->GetGeometryRef()->getGeometryType()), wkbMultiPolygon);
}

TEST(ExportLayers, ProfilePointsLieOnTheTraceWithTheirElevation) {
  const TestFolder folder;
  export_layers(region(), ExportFormat::geopackage, folder / "out.gpkg");
  const DatasetHandle gpkg = open_vector(folder / "out.gpkg");
  OGRLayer* profiles = gpkg->GetLayerByName("profiles");
  profiles->SetAttributeFilter("stage = 'after' AND x_m = 80");
  std::unique_ptr<OGRFeature> point(profiles->GetNextFeature());
  ASSERT_TRUE(point);
  EXPECT_DOUBLE_EQ(point->GetFieldAsDouble("elevation_m"), 21.7);
  EXPECT_DOUBLE_EQ(point->GetGeometryRef()->toPoint()->getX(), 380500);
  EXPECT_DOUBLE_EQ(point->GetGeometryRef()->toPoint()->getY(), 5113420);
  EXPECT_DOUBLE_EQ(point->GetGeometryRef()->toPoint()->getZ(), 21.7);
}

TEST(ExportLayers, GeoPackageCarriesTheStylesWhereQgisLooks) {
  const TestFolder folder;
  export_layers(region(), ExportFormat::geopackage, folder / "out.gpkg");
  const DatasetHandle gpkg = open_vector(folder / "out.gpkg");
  OGRLayer* type = gpkg->ExecuteSQL(
      "SELECT data_type FROM gpkg_contents WHERE table_name = 'layer_styles'", nullptr, "");
  ASSERT_NE(type, nullptr);
  std::unique_ptr<OGRFeature> row(type->GetNextFeature());
  ASSERT_TRUE(row);
  EXPECT_STREQ(row->GetFieldAsString(0), "attributes");
  row.reset();
  gpkg->ReleaseResultSet(type);
  OGRLayer* styles = gpkg->GetLayerByName("layer_styles");
  ASSERT_NE(styles, nullptr);
  EXPECT_EQ(styles->GetFeatureCount(), 4);
  EXPECT_STREQ(styles->GetFIDColumn(), "id");
  const char* columns[] = {"f_table_catalog", "f_table_schema", "f_table_name", "f_geometry_column",
                           "styleName",       "styleQML",       "styleSLD",     "useAsDefault",
                           "description",     "owner",          "ui",           "update_time"};
  for (const char* column : columns) {
    EXPECT_GE(styles->GetLayerDefn()->GetFieldIndex(column), 0) << column;
  }
  for (const auto& style : *styles) {
    OGRLayer* layer = gpkg->GetLayerByName(style->GetFieldAsString("f_table_name"));
    ASSERT_NE(layer, nullptr);
    EXPECT_STREQ(layer->GetGeometryColumn(), style->GetFieldAsString("f_geometry_column"));
    const std::string qml = style->GetFieldAsString("styleQML");
    CPLXMLNode* xml = CPLParseXMLString(qml.c_str());
    EXPECT_NE(xml, nullptr) << qml;
    CPLDestroyXMLNode(xml);
    EXPECT_NE(qml.find("renderer-v2"), std::string::npos);
    EXPECT_EQ(style->GetFieldAsInteger("useAsDefault"), 1);
  }
}

TEST(ExportLayers, NoOfficialHazardClassIsEverWritten) {
  const TestFolder folder;
  export_layers(region(), ExportFormat::geopackage, folder / "out.gpkg");
  const DatasetHandle gpkg = open_vector(folder / "out.gpkg");
  for (const char* name : {"release_zones", "runout_zones"}) {
    const OGRFeatureDefn* fields = gpkg->GetLayerByName(name)->GetLayerDefn();
    for (int i = 0; i < fields->GetFieldCount(); ++i) {
      const std::string field = fields->GetFieldDefn(i)->GetNameRef();
      EXPECT_TRUE(field == "region" || field == "job" || field.starts_with("leda_")) << field;
    }
  }
}

TEST(ExportLayers, GeoJsonIsInLongitudeAndLatitude) {
  const TestFolder folder;
  export_layers(region(), ExportFormat::geojson, folder / "out.geojson");
  EXPECT_EQ(text_of(folder / "out.geojson").find("\"crs\""), std::string::npos);
  const DatasetHandle json = open_vector(folder / "out.geojson");
  ASSERT_TRUE(json);
  OGRLayer* layer = json->GetLayer(0);
  EXPECT_EQ(layer->GetFeatureCount(), 4);
  int zones = 0;
  for (const auto& feature : *layer) {
    OGREnvelope box;
    feature->GetGeometryRef()->getEnvelope(&box);
    EXPECT_NEAR(box.MinX, -72.52, 0.02);
    EXPECT_NEAR(box.MinY, 46.155, 0.02);
    const OGRwkbGeometryType type = wkbFlatten(feature->GetGeometryRef()->getGeometryType());
    if (type != wkbPolygon) continue;
    ++zones;
    EXPECT_NEAR(feature->GetFieldAsDouble("leda_area_m2"), 1000, 1e-6);
    EXPECT_FALSE(feature->GetGeometryRef()->toPolygon()->getExteriorRing()->isClockwise());
  }
  EXPECT_EQ(zones, 2);
}

TEST(ExportLayers, ShapefilesAndFlatGeobufsComeZipped) {
  const TestFolder folder;
  for (const auto format : {ExportFormat::shapefile, ExportFormat::flatgeobuf}) {
    const std::string ending = format == ExportFormat::shapefile ? ".shp" : ".fgb";
    const fs::path zip = folder / ("out" + ending + ".zip");
    export_layers(region(), format, zip);
    const DatasetHandle sections = open_vector("/vsizip/" + zip.string() + "/sections" + ending);
    ASSERT_TRUE(sections);
    EXPECT_EQ(sections->GetLayer(0)->GetFeatureCount(), 2);
    EXPECT_STREQ(sections->GetLayer(0)->GetSpatialRef()->GetAuthorityCode(nullptr), "2950");
    std::unique_ptr<OGRFeature> first(sections->GetLayer(0)->GetNextFeature());
    const char* retrogression =
        format == ExportFormat::shapefile ? "leda_ret_m" : "leda_retrogression_m";
    bool found = false;
    for (; first; first.reset(sections->GetLayer(0)->GetNextFeature())) {
      if (std::string(first->GetFieldAsString("name")) != "AA'") continue;
      EXPECT_DOUBLE_EQ(first->GetFieldAsDouble(retrogression), 103.25);
      found = true;
    }
    EXPECT_TRUE(found);
    const DatasetHandle zones = open_vector("/vsizip/" + zip.string() + "/release_zones" + ending);
    ASSERT_TRUE(zones);
    EXPECT_EQ(zones->GetLayer(0)->GetFeatureCount(), 1);
  }
}

// The table of a Shapefile holds 254 bytes a field: lists end at a whole item and say so.
TEST(ExportLayers, LongTextsOfAShapefileEndAtAWholeItem) {
  const TestFolder folder;
  RegionLayers layers = region();
  Zone& zone = layers.zones[0];
  zone.sections.clear();
  zone.warnings.clear();
  for (int i = 1; i <= 58; ++i) {
    std::string name = "S0";
    name += std::to_string(i + 100).substr(1);
    zone.sections.push_back(name);
    zone.warnings.push_back(name + ": the front reached the model's edge; runout is a lower bound");
  }
  layers.sections[1].reason = std::string(251, 'x') + "\u00e9\u00e9\u00e9";
  export_layers(layers, ExportFormat::shapefile, folder / "out.shp.zip");
  export_layers(layers, ExportFormat::geopackage, folder / "out.gpkg");
  const std::string zip = "/vsizip/" + (folder / "out.shp.zip").string();
  const DatasetHandle cut = open_vector(zip + "/release_zones.shp");
  const std::unique_ptr<OGRFeature> first(cut->GetLayer(0)->GetNextFeature());
  const std::string names = first->GetFieldAsString("leda_sects");
  EXPECT_TRUE(names.ends_with("S037 and 21 more (see the GeoPackage)")) << names;
  const std::string told = first->GetFieldAsString("leda_warn");
  EXPECT_TRUE(told.ends_with("lower bound and 55 more (see the GeoPackage)")) << told;
  EXPECT_LE(told.size(), 254U);
  EXPECT_EQ(first->GetFieldAsInteger("leda_count"), 58);
  const DatasetHandle sections = open_vector(zip + "/sections.shp");
  sections->GetLayer(0)->SetAttributeFilter("name = 'S001'");
  const std::unique_ptr<OGRFeature> left_out(sections->GetLayer(0)->GetNextFeature());
  EXPECT_EQ(left_out->GetFieldAsString("leda_reas"), std::string(251, 'x') + "...");
  const DatasetHandle whole = open_vector(folder / "out.gpkg");
  const std::unique_ptr<OGRFeature> zone_row(
      whole->GetLayerByName("release_zones")->GetNextFeature());
  EXPECT_TRUE(std::string(zone_row->GetFieldAsString("leda_sections")).ends_with("S057, S058"));
}

TEST(ExportLayers, SayWhetherADistanceIsALowerBound) {
  const TestFolder folder;
  RegionLayers layers = region();
  layers.sections[0].retrogression_is = "lower-bound";
  layers.zones[0].distance_is = Bound::lower_bound;
  export_layers(layers, ExportFormat::geopackage, folder / "out.gpkg");
  const DatasetHandle gpkg = open_vector(folder / "out.gpkg");
  const auto first = [&](const char* layer) {
    return std::unique_ptr<OGRFeature>(gpkg->GetLayerByName(layer)->GetNextFeature());
  };
  EXPECT_STREQ(first("sections")->GetFieldAsString("leda_retrogression_is"), "lower-bound");
  EXPECT_STREQ(first("release_zones")->GetFieldAsString("leda_distance_is"), "lower-bound");
  EXPECT_STREQ(first("runout_zones")->GetFieldAsString("leda_distance_is"), "measured");
}

TEST(ExportLayers, ARegionWithoutZonesStillHasItsLayers) {
  const TestFolder folder;
  RegionLayers layers = region();
  layers.zones.clear();
  layers.sections.clear();
  for (const auto format : {ExportFormat::geopackage, ExportFormat::geojson,
                            ExportFormat::shapefile, ExportFormat::flatgeobuf}) {
    EXPECT_NO_THROW(
        export_layers(layers, format, folder / (std::string("out") + file_ending(format))));
  }
  const DatasetHandle gpkg = open_vector(folder / "out.gpkg");
  EXPECT_NE(gpkg->GetLayerByName("release_zones"), nullptr);
}

TEST(ExportLayers, AFailureLeavesTheOldFileAndNothingElse) {
  const TestFolder folder;
  export_layers(region(), ExportFormat::geojson, folder / "out.geojson");
  const std::string before = text_of(folder / "out.geojson");
  RegionLayers bad = region();
  bad.epsg = 999999;
  EXPECT_THROW(export_layers(bad, ExportFormat::geojson, folder / "out.geojson"), ExportError);
  EXPECT_THROW(export_layers(bad, ExportFormat::geopackage, folder / "out.gpkg"), ExportError);
  EXPECT_EQ(text_of(folder / "out.geojson"), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
  EXPECT_THROW(export_layers(region(), ExportFormat::geojson, folder / "none/out.geojson"),
               ExportError);
}

TEST(ExportLayers, NamesOfFormats) {
  EXPECT_EQ(export_format_from("gpkg"), ExportFormat::geopackage);
  EXPECT_EQ(export_format_from("fgb"), ExportFormat::flatgeobuf);
  EXPECT_FALSE(export_format_from("kml"));
  EXPECT_STREQ(media_type(ExportFormat::geojson), "application/geo+json");
}

TEST(ToCrs84, LongitudeFirstAndRingsAsRfc7946HasThem) {
  const ToCrs84 to_crs84(2950);
  const MapPoint p = to_crs84(MapPoint{380494.168, 5113269.150});
  EXPECT_NEAR(p.x, -72.52, 2e-5);
  EXPECT_NEAR(p.y, 46.155, 2e-5);
  const MapPolygon clockwise{
      {{380000, 5113000}, {380000, 5113100}, {380100, 5113100}, {380000, 5113000}}, {}};
  const MapPolygon turned = to_crs84(clockwise);
  EXPECT_NEAR(turned.outer[1].x, to_crs84(clockwise.outer[2]).x, 1e-12);
  EXPECT_THROW(ToCrs84(999999), ExportError);
}

}  // namespace
}  // namespace leda::profiles
