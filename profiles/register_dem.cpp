#include "profiles/register_dem.hpp"

#include <cpl_string.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "disk/new_file.hpp"
#include "disk/sha256.hpp"
#include "disk/temporary_file.hpp"
#include "profiles/gdal_error.hpp"
#include "profiles/ground_scale.hpp"
#include "profiles/safe_open.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

constexpr int strip_cells = 512;  // cells are copied in squares of this side
constexpr double lowest_ground_m = -500, highest_ground_m = 9000;
constexpr float written_nodata = -9999;

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

void copy_square(const Dem& dem, GDALRasterBand& band, int column, int row,
                 RepeatedValues& values) {
  const int width = std::min(strip_cells, dem.info().width - column);
  const int height = std::min(strip_cells, dem.info().height - row);
  std::vector<float> cells = dem.read(column, row, width, height, width, height);
  const double unit = dem.info().metres_per_vertical_unit;
  values.add(cells);
  for (float& z : cells) z = std::isnan(z) ? written_nodata : static_cast<float>(z / unit);
  if (band.RasterIO(GF_Write, column, row, width, height, cells.data(), width, height, GDT_Float32,
                    0, 0, nullptr) != CE_None) {
    throw DemError("can't write the raster" + gdal_message());
  }
}

void check_is_ground(const RepeatedValues& values) {
  if (values.with_data() == 0) {
    throw DemError("no cell of the raster holds data: check its nodata value with gdalinfo -stats");
  }
  if (values.lowest() < lowest_ground_m || values.highest() > highest_ground_m) {
    throw DemError("the raster's elevations run from " + std::to_string(values.lowest()) + " to " +
                   std::to_string(values.highest()) +
                   " m, which is no ground: declare the value of missing cells with gdal_edit.py "
                   "-a_nodata VALUE (or nodata = VALUE), or state the vertical unit");
  }
}

// Refused where no place of the DEM is fit for a section, told where some are not.
void check_scale(const Dem& dem, std::vector<std::string>& warnings) {
  const GroundScale scale(dem.info().epsg);
  const double w = dem.info().width, h = dem.info().height;
  const std::string name = "EPSG:" + std::to_string(dem.info().epsg) + ": ";
  std::string told, refused;
  bool fit = false;
  for (const double row : {h / 2, 0.0, h}) {
    for (const double column : {w / 2, 0.0, w}) {
      const MapPoint p = dem.to_map(column, row);
      if (told.empty()) told = scale.complaint_at(p, told_departure);
      const std::string here = scale.complaint_at(p, most_departure);
      fit = fit || here.empty();
      if (refused.empty()) refused = here;
    }
  }
  if (!fit) throw DemError(name + refused);
  if (!refused.empty()) told = refused + "; sections there are refused";
  if (!told.empty()) warnings.push_back(name + told);
}

std::optional<std::array<double, 2>> cell_on_ground(const Dem& dem) {
  const DemInfo& info = dem.info();
  const auto scale =
      GroundScale(info.epsg).along_axes(dem.to_map(info.width / 2.0, info.height / 2.0));
  if (!scale || info.rotated) return std::nullopt;
  return std::array{info.cell_x * info.metres_per_unit * (*scale)[0],
                    info.cell_y * info.metres_per_unit * (*scale)[1]};
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

RegisteredDem register_dem(const fs::path& input, const fs::path& output, const DemOptions& options,
                           Fills fills) {
  const Dem dem = Dem::open(input, options);
  const QuietGdal quiet;
  const disk::TemporaryFile tiled(output.string() + ".cells.tmp");
  disk::NewFile cog(output);
  RegisteredDem registered;
  check_scale(dem, registered.warnings);
  RepeatedValues values;
  {
    const DatasetHandle cells = create_tiled(tiled.path(), dem);
    for (int row = 0; row < dem.info().height; row += strip_cells) {
      for (int column = 0; column < dem.info().width; column += strip_cells) {
        copy_square(dem, *cells->GetRasterBand(1), column, row, values);
      }
    }
    check_is_ground(values);
    cells->FlushCache();
    write_cog(*cells, cog.part());
  }
  // Read back before it takes its place: what cannot be read again was never registered.
  registered.info =
      Dem::open(cog.part(), {.vertical_unit = "", .epsg = 0, .limits = options.limits}).info();
  registered.sha256 = disk::sha256_of_file(cog.part());
  registered.bytes = static_cast<std::int64_t>(fs::file_size(cog.part()));
  registered.lowest_m = static_cast<double>(values.lowest());
  registered.highest_m = static_cast<double>(values.highest());
  registered.cell_ground_m = cell_on_ground(dem);
  if (fills == Fills::look_for) {
    const FoundFills found = find_undeclared_fills(dem, values);
    registered.fill = found.taken;
    std::ranges::copy(warnings_of(found), std::back_inserter(registered.warnings));
  }
  registered.share_with_data = static_cast<double>(values.with_data()) /
                               (static_cast<double>(dem.info().width) * dem.info().height);
  cog.keep();
  return registered;
}

}  // namespace leda::profiles
