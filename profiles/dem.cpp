#include "profiles/dem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <unordered_map>

#include "profiles/gdal_error.hpp"
#include "profiles/safe_open.hpp"

namespace leda::profiles {
namespace {

constexpr int tile_cells = 256;          // along each side
constexpr std::size_t most_tiles = 128;  // 32 MiB
constexpr float no_data = std::numeric_limits<float>::quiet_NaN();

constexpr double equal_elevations = 1e-6;  // relative: a unit's rounding, no more
constexpr double on_edge_cells = 1e-6;     // rounding of the inverse geotransform

using GridTransform = std::array<double, 6>;

MapPoint apply(const GridTransform& t, double column, double row) {
  return {t[0] + t[1] * column + t[2] * row, t[3] + t[4] * column + t[5] * row};
}

GridTransform transform_of(GDALDataset& dataset, GridTransform& inverse) {
  GridTransform t{};
  const bool known = dataset.GetGeoTransform(t.data()) == CE_None;
  const bool finite = std::all_of(t.begin(), t.end(), [](double v) { return std::isfinite(v); });
  if (!known || !finite || GDALInvGeoTransform(t.data(), inverse.data()) == 0) {
    throw DemError(
        "the raster does not say where on the map it lies (no usable geotransform): write it into "
        "the file with gdal_edit.py -a_ullr WEST NORTH EAST SOUTH");
  }
  return t;
}

MapBox box_of(const GridTransform& t, int width, int height) {
  const double w = width, h = height;
  const MapPoint corners[] = {apply(t, 0, 0), apply(t, w, 0), apply(t, 0, h), apply(t, w, h)};
  MapBox box{corners[0].x, corners[0].y, corners[0].x, corners[0].y};
  for (const MapPoint& p : corners) {
    box = {std::min(box[0], p.x), std::min(box[1], p.y), std::max(box[2], p.x),
           std::max(box[3], p.y)};
  }
  return box;
}

// Degrees filed under a projected system lie within a few hundred units of its origin.
void check_not_degrees(const DemInfo& info) {
  const bool small = std::abs(info.box[0]) <= 360 && std::abs(info.box[2]) <= 360 &&
                     std::abs(info.box[1]) <= 90 && std::abs(info.box[3]) <= 90;
  if (small && std::max(info.cell_x, info.cell_y) < 0.02) {
    throw DemError("the raster's cells are " + std::to_string(info.cell_x) +
                   " map units wide and lie within 360 x 90 units of the origin: these are "
                   "degrees. Reproject it, for example gdalwarp -s_srs EPSG:4326 -t_srs EPSG:2950");
  }
}

}  // namespace

struct Dem::Raster {
  struct Tile {
    int width = 0;
    std::vector<float> elevations;
    std::list<std::int64_t>::iterator age;
  };

  DatasetHandle dataset;
  GDALRasterBand* band = nullptr;
  DemInfo info;
  GridTransform to_map{};
  GridTransform to_grid{};
  std::optional<double> nodata;
  bool has_mask = false;
  double scale = 1, offset = 0;  // raw value to metres

  std::unordered_map<std::int64_t, Tile> tiles;
  std::list<std::int64_t> by_age;  // newest first

  std::vector<float> read(int column, int row, int width, int height, int columns, int rows) const;
  float to_metres(double raw) const;
  float cell(int column, int row);
  const Tile& tile_at(int tile_column, int tile_row);
};

float Dem::Raster::to_metres(double raw) const {
  if (!std::isfinite(raw) || std::abs(raw) > 1e30) return no_data;
  if (nodata && (raw == *nodata || static_cast<float>(raw) == static_cast<float>(*nodata))) {
    return no_data;
  }
  const double metres = raw * scale + offset;
  if (info.missing_m && std::abs(metres - *info.missing_m) <=
                            equal_elevations * std::max(1.0, std::abs(*info.missing_m))) {
    return no_data;
  }
  return static_cast<float>(metres);
}

std::vector<float> Dem::Raster::read(int column, int row, int width, int height, int columns,
                                     int rows) const {
  const QuietGdal quiet;
  const auto count = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  std::vector<double> raw(count);
  GDALRasterIOExtraArg extra;
  INIT_RASTERIO_EXTRA_ARG(extra);
  extra.eResampleAlg = GRIORA_Average;
  bool ok = band->RasterIO(GF_Read, column, row, width, height, raw.data(), columns, rows,
                           GDT_Float64, 0, 0, &extra) == CE_None;
  std::vector<unsigned char> valid;
  if (ok && has_mask) {
    valid.resize(count);
    ok = band->GetMaskBand()->RasterIO(GF_Read, column, row, width, height, valid.data(), columns,
                                       rows, GDT_Byte, 0, 0, nullptr) == CE_None;
  }
  if (!ok) throw DemError("the raster can't be read" + gdal_message());
  std::vector<float> metres(count);
  for (std::size_t i = 0; i < count; ++i) {
    metres[i] = has_mask && valid[i] == 0 ? no_data : to_metres(raw[i]);
  }
  return metres;
}

const Dem::Raster::Tile& Dem::Raster::tile_at(int tile_column, int tile_row) {
  const std::int64_t key = (std::int64_t{tile_row} << 32) | tile_column;
  if (const auto found = tiles.find(key); found != tiles.end()) {
    by_age.splice(by_age.begin(), by_age, found->second.age);
    return found->second;
  }
  const int column = tile_column * tile_cells, row = tile_row * tile_cells;
  const int width = std::min(tile_cells, info.width - column);
  const int height = std::min(tile_cells, info.height - row);
  std::vector<float> elevations = read(column, row, width, height, width, height);
  if (tiles.size() >= most_tiles) {
    tiles.erase(by_age.back());
    by_age.pop_back();
  }
  by_age.push_front(key);
  return tiles[key] = Tile{width, std::move(elevations), by_age.begin()};
}

float Dem::Raster::cell(int column, int row) {
  const Tile& tile = tile_at(column / tile_cells, row / tile_cells);
  return tile.elevations[static_cast<std::size_t>(row % tile_cells) *
                             static_cast<std::size_t>(tile.width) +
                         static_cast<std::size_t>(column % tile_cells)];
}

std::string note_on_missing(const DemInfo& info) {
  if (!info.missing_m) return "";
  return fmt::format(
      ". Cells of exactly {:g} m count as missing, as found when the DEM was registered: register "
      "it with nodata = none if they are ground",
      *info.missing_m);
}

double DemInfo::cell_m() const { return std::min(cell_x, cell_y) * metres_per_unit; }

Dem::Dem(std::unique_ptr<Raster> raster) : raster_(std::move(raster)) {}
Dem::~Dem() = default;
Dem::Dem(Dem&&) noexcept = default;
Dem& Dem::operator=(Dem&&) noexcept = default;

Dem Dem::open(const std::filesystem::path& file, const DemOptions& options) {
  auto raster = std::make_unique<Raster>();
  raster->dataset = open_safely(file, options.limits);
  GDALDataset& dataset = *raster->dataset;
  raster->band = dataset.GetRasterBand(1);

  DemInfo& info = raster->info;
  const OGRSpatialReference crs = horizontal_crs(dataset, options.epsg, info.epsg);
  info.crs_name = crs.GetName();
  info.metres_per_unit = crs.GetLinearUnits();
  info.width = dataset.GetRasterXSize();
  info.height = dataset.GetRasterYSize();
  raster->to_map = transform_of(dataset, raster->to_grid);
  const GridTransform& t = raster->to_map;
  info.cell_x = std::hypot(t[1], t[4]);
  info.cell_y = std::hypot(t[2], t[5]);
  info.rotated = t[2] != 0 || t[4] != 0;
  info.box = box_of(t, info.width, info.height);
  check_not_degrees(info);

  info.vertical_unit = vertical_unit(dataset, options.vertical_unit);
  info.metres_per_vertical_unit = metres_per_vertical_unit(info.vertical_unit);
  raster->scale = raster->band->GetScale() * info.metres_per_vertical_unit;
  raster->offset = raster->band->GetOffset() * info.metres_per_vertical_unit;
  int has_nodata = 0;
  const double nodata = raster->band->GetNoDataValue(&has_nodata);
  if (has_nodata != 0) raster->nodata = nodata;
  if (options.nodata) raster->nodata = options.nodata;
  info.missing_m = options.missing_m;
  raster->has_mask = (raster->band->GetMaskFlags() & GMF_PER_DATASET) != 0;
  return Dem(std::move(raster));
}

const DemInfo& Dem::info() const { return raster_->info; }

MapPoint Dem::to_map(double column, double row) const {
  return apply(raster_->to_map, column, row);
}

std::array<double, 2> Dem::to_grid(MapPoint p) const {
  const MapPoint grid = apply(raster_->to_grid, p.x, p.y);
  return {grid.x, grid.y};
}

bool Dem::contains(MapPoint p) const {
  const auto [column, row] = to_grid(p);
  // Points on the very edge come out of the inverse a rounding error within or beyond it.
  return column >= -on_edge_cells && column <= info().width + on_edge_cells &&
         row >= -on_edge_cells && row <= info().height + on_edge_cells;
}

std::optional<double> Dem::sample(MapPoint p) const {
  if (!contains(p)) return std::nullopt;
  const auto [column, row] = to_grid(p);
  const double c = std::clamp(column - 0.5, 0.0, info().width - 1.0);
  const double r = std::clamp(row - 0.5, 0.0, info().height - 1.0);
  const int c0 = static_cast<int>(c), r0 = static_cast<int>(r);
  const double fc = c - c0, fr = r - r0;
  double z = 0;
  for (int dr = 0; dr < 2; ++dr) {
    for (int dc = 0; dc < 2; ++dc) {
      const double weight = (dc != 0 ? fc : 1 - fc) * (dr != 0 ? fr : 1 - fr);
      if (weight == 0) continue;
      const double elevation = raster_->cell(c0 + dc, r0 + dr);
      if (std::isnan(elevation)) return std::nullopt;
      z += weight * elevation;
    }
  }
  return z;
}

std::vector<float> Dem::read(int column, int row, int width, int height, int columns,
                             int rows) const {
  const bool inside = column >= 0 && row >= 0 && width > 0 && height > 0 &&
                      column <= info().width - width && row <= info().height - height &&
                      columns > 0 && rows > 0;
  if (!inside) throw DemError("the window does not lie within the DEM");
  return raster_->read(column, row, width, height, columns, rows);
}

}  // namespace leda::profiles
