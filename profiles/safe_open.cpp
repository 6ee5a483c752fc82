#include "profiles/safe_open.hpp"

#include <cpl_conv.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <mutex>
#include <string_view>

#include "profiles/gdal_error.hpp"
#include "profiles/network_fence.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t most_block_bytes = std::int64_t{256} << 20;

// A network name ("/vsicurl/...") reaches GDAL's file layer before any driver is chosen.
void check_is_plain_file(const fs::path& file) {
  if (file.string().starts_with("/vsi")) {
    throw DemError("a DEM must be a file on this machine, not '" + file.string() + "'");
  }
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    throw DemError("there is no file '" + file.string() + "'");
  }
}

void check_size(GDALDataset& dataset, const DemLimits& limits) {
  const std::int64_t width = dataset.GetRasterXSize();
  const std::int64_t height = dataset.GetRasterYSize();
  GDALRasterBand& band = *dataset.GetRasterBand(1);
  const std::int64_t cell_bytes = GDALGetDataTypeSizeBytes(band.GetRasterDataType());
  const double bytes = static_cast<double>(width) * static_cast<double>(height) *
                       static_cast<double>(cell_bytes) * dataset.GetRasterCount();
  const std::string size = std::to_string(width) + " x " + std::to_string(height) + " cells";
  if (bytes > static_cast<double>(limits.most_bytes)) {
    throw DemError("the raster declares " + size + ", " +
                   std::to_string(std::llround(bytes / (1 << 20))) + " MiB; at most " +
                   std::to_string(limits.most_bytes >> 20) +
                   " MiB are read: cut out the reach you need (gdal_translate -projwin)");
  }
  int block_width = 0, block_height = 0;
  band.GetBlockSize(&block_width, &block_height);
  if (std::int64_t{block_width} * block_height * cell_bytes > most_block_bytes) {
    throw DemError("the raster is stored in blocks of " + std::to_string(block_width) + " x " +
                   std::to_string(block_height) +
                   " cells, too large to read in windows: gdal_translate -co TILED=YES");
  }
}

void check_bands(GDALDataset& dataset) {
  if (dataset.GetRasterCount() != 1) {
    throw DemError("the raster has " + std::to_string(dataset.GetRasterCount()) +
                   " bands, a DEM has one: choose it with gdal_translate -b 1");
  }
  if (GDALDataTypeIsComplex(dataset.GetRasterBand(1)->GetRasterDataType()) != 0) {
    throw DemError("the raster holds complex numbers, a DEM holds elevations");
  }
}

/// 0 where the code is none of EPSG's.
int epsg_number(const char* authority, const char* code) {
  if (authority == nullptr || code == nullptr || std::string_view(authority) != "EPSG") return 0;
  const std::string_view digits = code;
  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

int epsg_of(OGRSpatialReference& crs) {
  crs.AutoIdentifyEPSG();
  const int own = epsg_number(crs.GetAuthorityName(nullptr), crs.GetAuthorityCode(nullptr));
  if (own != 0) return own;

  int count = 0;
  int* confidence = nullptr;
  OGRSpatialReferenceH* matches =
      OSRFindMatches(OGRSpatialReference::ToHandle(&crs), nullptr, &count, &confidence);
  int found = 0;
  for (int i = 0; i < count && found == 0; ++i) {
    if (confidence[i] < 90) continue;
    found = epsg_number(OSRGetAuthorityName(matches[i], nullptr),
                        OSRGetAuthorityCode(matches[i], nullptr));
  }
  OSRFreeSRSArray(matches);
  CPLFree(confidence);
  return found;
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Empty where the words are not known.
std::string unit_named(const std::string& words) {
  const std::string text = lower(words);
  for (const char* name : {"m", "metre", "meter", "metres", "meters"}) {
    if (text == name) return "m";
  }
  for (const char* name : {"ft", "foot", "feet", "international foot", "international feet"}) {
    if (text == name) return "ft";
  }
  for (const char* name : {"us-ft", "ftus", "us survey foot", "us survey feet", "us_survey_foot",
                           "foot_us", "survey foot", "u.s. survey foot"}) {
    if (text == name) return "us-ft";
  }
  return "";
}

const char* const state_vertical_unit =
    ": say which one with vertical_unit = \"m\", \"ft\" or \"us-ft\" (leda map --vertical-unit)";

}  // namespace

void initialize_gdal() {
  static std::once_flag once;
  std::call_once(once, [] {
    CPLSetConfigOption("GDAL_SKIP",
                       "VRT,OGR_VRT,HTTP,WMS,WCS,WFS,OAPIF,OGCAPI,STACIT,STACTA,DERIVED,PDF");
    CPLSetConfigOption("GDAL_DRIVER_PATH", "disable");
    CPLSetConfigOption("CPL_VSIL_CURL_ALLOWED_FILENAME", "none");
    CPLSetConfigOption("GDAL_DISABLE_READDIR_ON_OPEN", "EMPTY_DIR");
    CPLSetConfigOption("GDAL_PAM_ENABLED", "NO");
    CPLSetConfigOption("GDAL_VRT_ENABLE_PYTHON", "NO");
    CPLSetConfigOption("GDAL_CACHEMAX", "128");
    OSRSetPROJEnableNetwork(0);
    close_network();
    // Only these exist in the process: nothing else can be opened, whatever a file says it is.
    GDALRegister_GTiff();
    GDALRegister_COG();
    GDALRegister_AAIGrid();
    GDALRegister_MEM();
    GDALRegister_PNG();
    RegisterOGRGeoPackage();
    RegisterOGRGeoJSON();
    RegisterOGRShape();
    RegisterOGRFlatGeobuf();
  });
}

DatasetHandle open_safely(const fs::path& file, const DemLimits& limits) {
  initialize_gdal();
  check_is_plain_file(file);
  const QuietGdal quiet;
  static const char* const drivers[] = {"GTiff", "COG", "AAIGrid", nullptr};
  DatasetHandle dataset(GDALDataset::Open(
      fs::absolute(file).c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, nullptr, nullptr));
  if (!dataset || dataset->GetRasterCount() < 1) {
    throw DemError("the file is not a GeoTIFF, COG or Arc ASCII grid that can be read" +
                   gdal_message());
  }
  check_size(*dataset, limits);
  check_bands(*dataset);
  return dataset;
}

OGRSpatialReference horizontal_crs(GDALDataset& dataset, int stated_epsg, int& epsg) {
  const QuietGdal quiet;
  OGRSpatialReference crs;
  const OGRSpatialReference* own = dataset.GetSpatialRef();
  if (own && !own->IsEmpty()) {
    crs = *own;
  } else if (stated_epsg == 0) {
    throw DemError(
        "the raster has no coordinate reference system: state its EPSG code (epsg = 2950, for "
        "example; leda map --epsg 2950), or write it into the file with gdal_edit.py -a_srs "
        "EPSG:2950");
  } else if (crs.importFromEPSG(stated_epsg) != OGRERR_NONE) {
    throw DemError("EPSG:" + std::to_string(stated_epsg) + " is not a known code");
  }
  if (crs.IsGeographic() != 0) {
    throw DemError(
        "the raster is in degrees (" + std::string(crs.GetName()) +
        "): reproject it to a projected system in metres, for example gdalwarp -t_srs EPSG:2950");
  }
  if (crs.IsProjected() == 0) {
    throw DemError(
        "the raster's coordinate reference system is not a projected one: write the right one into "
        "the file with gdal_edit.py -a_srs EPSG:2950 (for example)");
  }
  if (crs.IsCompound() != 0) crs.StripVertical();
  epsg = epsg_of(crs);
  if (epsg == 0) {
    throw DemError("the raster's projected system (" + std::string(crs.GetName()) +
                   ") has no EPSG code: reproject it to one that has, for example gdalwarp -t_srs "
                   "EPSG:2950");
  }
  if (stated_epsg != 0 && stated_epsg != epsg) {
    throw DemError("epsg = " + std::to_string(stated_epsg) + " is stated, the raster says EPSG:" +
                   std::to_string(epsg) + ": leave epsg out, or correct the file");
  }
  return crs;
}

std::string vertical_unit(GDALDataset& dataset, const std::string& stated) {
  if (!stated.empty()) {
    metres_per_vertical_unit(stated);
    return stated;
  }
  const std::string band = dataset.GetRasterBand(1)->GetUnitType();
  if (!band.empty()) {
    std::string unit = unit_named(band);
    if (!unit.empty()) return unit;
    throw DemError("the raster's elevations are in '" + band + "'" + state_vertical_unit);
  }
  const OGRSpatialReference* crs = dataset.GetSpatialRef();
  if (!crs) return "m";
  if (crs->IsCompound() != 0) {
    const char* name = nullptr;
    const double factor = crs->GetTargetLinearUnits("VERT_CS", &name);
    for (const char* unit : {"m", "ft", "us-ft"}) {
      if (std::abs(factor - metres_per_vertical_unit(unit)) < 1e-9) return unit;
    }
    throw DemError("the raster's vertical system is in '" + std::string(name ? name : "") + "'" +
                   state_vertical_unit);
  }
  if (std::abs(crs->GetLinearUnits() - 1) > 1e-9) {
    throw DemError(
        "the raster's map unit is not the metre and nothing says what unit its "
        "elevations are in" +
        std::string(state_vertical_unit));
  }
  return "m";
}

double metres_per_vertical_unit(const std::string& unit) {
  if (unit == "m") return 1;
  if (unit == "ft") return 0.3048;
  if (unit == "us-ft") return 1200.0 / 3937.0;
  throw DemError("vertical_unit is '" + unit + "', it must be \"m\", \"ft\" or \"us-ft\"");
}

}  // namespace leda::profiles
