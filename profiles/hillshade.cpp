#include "profiles/hillshade.hpp"

#include <gdal_priv.h>
#include <gdal_utils.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "profiles/gdal_error.hpp"
#include "profiles/gdal_handle.hpp"
#include "profiles/work_folder.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

// Elevations of the picture's pixels, north up, west left.
struct Ground {
  Picture picture;
  double pixel_x_m = 0, pixel_y_m = 0;
  std::vector<float> elevations;
};

struct GridWindow {
  int column = 0, row = 0, width = 0, height = 0;
};

GridWindow window_on_grid(const Dem& dem, const std::optional<MapBox>& box) {
  const DemInfo& info = dem.info();
  if (!box) return {0, 0, info.width, info.height};
  double west = std::numeric_limits<double>::max(), north = west, east = -west, south = -west;
  const auto& b = *box;
  for (const MapPoint corner :
       {MapPoint{b[0], b[1]}, MapPoint{b[0], b[3]}, MapPoint{b[2], b[1]}, MapPoint{b[2], b[3]}}) {
    const auto [column, row] = dem.to_grid(corner);
    west = std::min(west, column);
    east = std::max(east, column);
    north = std::min(north, row);
    south = std::max(south, row);
  }
  const auto held = [](double v, int most) {
    return std::clamp(v, 0.0, static_cast<double>(most));
  };
  const int c0 = static_cast<int>(std::floor(held(west, info.width)));
  const int r0 = static_cast<int>(std::floor(held(north, info.height)));
  const int c1 = static_cast<int>(std::ceil(held(east, info.width)));
  const int r1 = static_cast<int>(std::ceil(held(south, info.height)));
  if (!(c1 > c0 && r1 > r0)) throw DemError("the window does not meet the DEM");
  return {c0, r0, c1 - c0, r1 - r0};
}

void turn_north_up(const Dem& dem, Ground& ground) {
  const MapPoint origin = dem.to_map(0, 0);
  const auto width = static_cast<std::ptrdiff_t>(ground.picture.width);
  auto& cells = ground.elevations;
  if (dem.to_map(1, 0).x < origin.x) {
    for (auto row = cells.begin(); row != cells.end(); row += width) std::reverse(row, row + width);
  }
  if (dem.to_map(0, 1).y > origin.y) {
    auto top = cells.begin(), bottom = cells.end() - width;
    for (; top < bottom; top += width, bottom -= width) std::swap_ranges(top, top + width, bottom);
  }
}

Ground read_ground(const Dem& dem, const HillshadeOptions& options) {
  const GridWindow w = window_on_grid(dem, options.window);
  const double shrink =
      std::max(1.0, static_cast<double>(std::max(w.width, w.height)) / options.most_pixels);
  Ground ground;
  ground.picture.width = std::max(1, static_cast<int>(w.width / shrink));
  ground.picture.height = std::max(1, static_cast<int>(w.height / shrink));
  const MapPoint a = dem.to_map(w.column, w.row);
  const MapPoint b = dem.to_map(w.column + w.width, w.row + w.height);
  ground.picture.box = {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x),
                        std::max(a.y, b.y)};
  const DemInfo& info = dem.info();
  ground.pixel_x_m = info.cell_x * info.metres_per_unit * w.width / ground.picture.width;
  ground.pixel_y_m = info.cell_y * info.metres_per_unit * w.height / ground.picture.height;
  ground.elevations =
      dem.read(w.column, w.row, w.width, w.height, ground.picture.width, ground.picture.height);
  turn_north_up(dem, ground);
  return ground;
}

DatasetHandle to_dataset(const Ground& ground) {
  const int width = ground.picture.width, height = ground.picture.height;
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  DatasetHandle dataset(driver->Create("", width, height, 1, GDT_Float32, nullptr));
  if (!dataset) throw DemError("not enough memory for the picture" + gdal_message());
  double transform[] = {0, ground.pixel_x_m, 0, 0, 0, -ground.pixel_y_m};
  dataset->SetGeoTransform(transform);
  GDALRasterBand* band = dataset->GetRasterBand(1);
  band->SetNoDataValue(std::nan(""));
  std::vector<float> cells = ground.elevations;
  const CPLErr result = band->RasterIO(GF_Write, 0, 0, width, height, cells.data(), width, height,
                                       GDT_Float32, 0, 0, nullptr);
  if (result != CE_None) throw DemError("the picture can't be drawn" + gdal_message());
  return dataset;
}

// Grey from 1 to 255, 0 where there is no data.
std::vector<std::uint8_t> shade(const Ground& ground, const HillshadeOptions& options) {
  const DatasetHandle elevations = to_dataset(ground);
  const std::string azimuth = std::to_string(options.azimuth_deg),
                    altitude = std::to_string(options.altitude_deg),
                    exaggeration = std::to_string(options.vertical_exaggeration);
  std::vector<const char*> words{"-of",
                                 "MEM",
                                 "-compute_edges",
                                 "-az",
                                 azimuth.c_str(),
                                 "-alt",
                                 altitude.c_str(),
                                 "-z",
                                 exaggeration.c_str(),
                                 nullptr};
  const std::unique_ptr<GDALDEMProcessingOptions, decltype(&GDALDEMProcessingOptionsFree)> how(
      GDALDEMProcessingOptionsNew(const_cast<char**>(words.data()), nullptr),
      GDALDEMProcessingOptionsFree);
  const DatasetHandle shaded(GDALDataset::FromHandle(GDALDEMProcessing(
      "", GDALDataset::ToHandle(elevations.get()), "hillshade", nullptr, how.get(), nullptr)));
  const int width = ground.picture.width, height = ground.picture.height;
  std::vector<std::uint8_t> grey(ground.elevations.size());
  const bool drawn =
      shaded && shaded->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, width, height, grey.data(), width,
                                                   height, GDT_Byte, 0, 0, nullptr) == CE_None;
  if (!drawn) throw DemError("the picture can't be drawn" + gdal_message());
  return grey;
}

void write_png(const Picture& picture, std::vector<std::uint8_t> grey, const fs::path& png) {
  std::vector<std::uint8_t> alpha(grey.size());
  std::ranges::transform(grey, alpha.begin(), [](std::uint8_t g) { return g == 0 ? 0 : 255; });
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  const DatasetHandle memory(
      driver->Create("", picture.width, picture.height, 2, GDT_Byte, nullptr));
  if (!memory) throw DemError("not enough memory for the picture" + gdal_message());
  const MapBox& b = picture.box;
  double transform[] = {b[0], (b[2] - b[0]) / picture.width, 0, b[3],
                        0,    (b[1] - b[3]) / picture.height};
  memory->SetGeoTransform(transform);
  int number = 0;
  for (auto* band : {&grey, &alpha}) {
    const CPLErr result = memory->GetRasterBand(++number)->RasterIO(
        GF_Write, 0, 0, picture.width, picture.height, band->data(), picture.width, picture.height,
        GDT_Byte, 0, 0, nullptr);
    if (result != CE_None) throw DemError("the picture can't be drawn" + gdal_message());
  }
  memory->GetRasterBand(2)->SetColorInterpretation(GCI_AlphaBand);
  const WorkFolder work(png);
  if (!work.exists()) throw DemError("can't write beside " + png.string());
  const fs::path temporary = work.path() / png.filename();
  GDALDriver* to_png = GetGDALDriverManager()->GetDriverByName("PNG");
  DatasetHandle written(to_png->CreateCopy(temporary.c_str(), memory.get(), FALSE, nullptr,
                                           GDALDummyProgress, nullptr));
  if (!written) throw DemError("can't write " + png.string() + gdal_message());
  written.reset();
  fs::rename(temporary, png);
}

}  // namespace

Picture write_hillshade(const Dem& dem, const fs::path& png, const HillshadeOptions& options) {
  const QuietGdal quiet;
  const Ground ground = read_ground(dem, options);
  write_png(ground.picture, shade(ground, options), png);
  return ground.picture;
}

}  // namespace leda::profiles
