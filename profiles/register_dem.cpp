#include "profiles/register_dem.hpp"

#include <cpl_string.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "profiles/gdal_error.hpp"
#include "profiles/safe_open.hpp"
#include "profiles/sha256.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

constexpr int strip_cells = 512;  // cells are copied in squares of this side
constexpr double lowest_ground_m = -500, highest_ground_m = 9000;
constexpr float written_nodata = -9999;

// Removes what was begun where registering fails.
class TemporaryFile {
 public:
  explicit TemporaryFile(fs::path path) : path_(std::move(path)) {}
  ~TemporaryFile() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

DatasetHandle create_tiled(const fs::path& file, const Dem& dem) {
  const DemInfo& info = dem.info();
  CPLStringList how;
  how.SetNameValue("TILED", "YES");
  how.SetNameValue("BLOCKXSIZE", "512");
  how.SetNameValue("BLOCKYSIZE", "512");
  how.SetNameValue("COMPRESS", "LZW");
  how.SetNameValue("SPARSE_OK", "TRUE");
  how.SetNameValue("BIGTIFF", "IF_SAFER");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  DatasetHandle dataset(
      driver->Create(file.c_str(), info.width, info.height, 1, GDT_Float32, how.List()));
  if (!dataset) throw DemError("can't write " + file.string() + gdal_message());
  OGRSpatialReference crs;
  crs.importFromEPSG(info.epsg);
  dataset->SetSpatialRef(&crs);
  // Over the whole width and height: rounding then stays below a cell's millionth part.
  const double w = info.width, h = info.height;
  const MapPoint o = dem.to_map(0, 0), x = dem.to_map(w, 0), y = dem.to_map(0, h);
  double transform[] = {o.x, (x.x - o.x) / w, (y.x - o.x) / h,
                        o.y, (x.y - o.y) / w, (y.y - o.y) / h};
  dataset->SetGeoTransform(transform);
  dataset->GetRasterBand(1)->SetNoDataValue(written_nodata);
  dataset->GetRasterBand(1)->SetUnitType(info.vertical_unit.c_str());
  return dataset;
}

struct Extent {
  double lowest_m = std::numeric_limits<double>::infinity();
  double highest_m = -std::numeric_limits<double>::infinity();
  std::int64_t with_data = 0;
};

void copy_square(const Dem& dem, GDALRasterBand& band, int column, int row, Extent& extent) {
  const int width = std::min(strip_cells, dem.info().width - column);
  const int height = std::min(strip_cells, dem.info().height - row);
  std::vector<float> cells = dem.read(column, row, width, height, width, height);
  const double unit = dem.info().metres_per_vertical_unit;
  for (float& z : cells) {
    if (std::isnan(z)) {
      z = written_nodata;
      continue;
    }
    extent.lowest_m = std::min<double>(extent.lowest_m, z);
    extent.highest_m = std::max<double>(extent.highest_m, z);
    ++extent.with_data;
    z = static_cast<float>(z / unit);
  }
  if (band.RasterIO(GF_Write, column, row, width, height, cells.data(), width, height, GDT_Float32,
                    0, 0, nullptr) != CE_None) {
    throw DemError("can't write the raster" + gdal_message());
  }
}

void check_is_ground(const Extent& extent) {
  if (extent.with_data == 0) {
    throw DemError("no cell of the raster holds data: check its nodata value with gdalinfo -stats");
  }
  if (extent.lowest_m < lowest_ground_m || extent.highest_m > highest_ground_m) {
    throw DemError("the raster's elevations run from " + std::to_string(extent.lowest_m) + " to " +
                   std::to_string(extent.highest_m) +
                   " m, which is no ground: declare the value of missing cells with gdal_edit.py "
                   "-a_nodata VALUE, or state the vertical unit");
  }
}

void write_cog(GDALDataset& from, const fs::path& to) {
  CPLStringList how;
  how.SetNameValue("COMPRESS", "DEFLATE");
  how.SetNameValue("PREDICTOR", "YES");
  how.SetNameValue("RESAMPLING", "AVERAGE");
  how.SetNameValue("BIGTIFF", "IF_SAFER");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("COG");
  DatasetHandle cog(
      driver->CreateCopy(to.c_str(), &from, FALSE, how.List(), GDALDummyProgress, nullptr));
  if (!cog) throw DemError("can't write " + to.string() + gdal_message());
}

}  // namespace

RegisteredDem register_dem(const fs::path& input, const fs::path& output,
                           const DemOptions& options) {
  const Dem dem = Dem::open(input, options);
  const QuietGdal quiet;
  const TemporaryFile tiled(output.string() + ".cells.tmp");
  const TemporaryFile cog(output.string() + ".cog.tmp");
  Extent extent;
  {
    const DatasetHandle cells = create_tiled(tiled.path(), dem);
    for (int row = 0; row < dem.info().height; row += strip_cells) {
      for (int column = 0; column < dem.info().width; column += strip_cells) {
        copy_square(dem, *cells->GetRasterBand(1), column, row, extent);
      }
    }
    check_is_ground(extent);
    cells->FlushCache();
    write_cog(*cells, cog.path());
  }
  // Read back before it takes its place: what cannot be read again was never registered.
  RegisteredDem registered;
  registered.info =
      Dem::open(cog.path(), {.vertical_unit = "", .epsg = 0, .limits = options.limits}).info();
  registered.sha256 = sha256_of_file(cog.path());
  registered.bytes = static_cast<std::int64_t>(fs::file_size(cog.path()));
  registered.lowest_m = extent.lowest_m;
  registered.highest_m = extent.highest_m;
  registered.share_with_data = static_cast<double>(extent.with_data) /
                               (static_cast<double>(dem.info().width) * dem.info().height);
  fs::rename(cog.path(), output);
  return registered;
}

}  // namespace leda::profiles
