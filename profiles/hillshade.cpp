#include "profiles/hillshade.hpp"

#include <gdal_alg.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "profiles/areas.hpp"
#include "profiles/gdal_error.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

// Elevations of the picture's pixels, north up, west left.
struct Ground {
  Picture picture;
  double pixel_x_m = 0, pixel_y_m = 0;
  std::vector<float> elevations;

  float at(int column, int row) const {
    column = std::clamp(column, 0, picture.width - 1);
    row = std::clamp(row, 0, picture.height - 1);
    return elevations[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                      static_cast<std::size_t>(column)];
  }
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

// Horn 1981: the gradient from the eight neighbours; then the cosine of the angle to the light.
double brightness(const Ground& g, int c, int r, const HillshadeOptions& options) {
  const auto z = [&](int dc, int dr) {
    const double value = g.at(c + dc, r + dr);
    return std::isnan(value) ? g.at(c, r) : value;
  };
  const double k = options.vertical_exaggeration / 8;
  const double east =
      k / g.pixel_x_m * (z(1, -1) + 2 * z(1, 0) + z(1, 1) - z(-1, -1) - 2 * z(-1, 0) - z(-1, 1));
  const double north =
      k / g.pixel_y_m * (z(-1, -1) + 2 * z(0, -1) + z(1, -1) - z(-1, 1) - 2 * z(0, 1) - z(1, 1));
  constexpr double degree = 3.14159265358979323846 / 180;
  const double flat = std::cos(options.altitude_deg * degree);
  const double up = std::sin(options.altitude_deg * degree);
  const double light_east = flat * std::sin(options.azimuth_deg * degree);
  const double light_north = flat * std::cos(options.azimuth_deg * degree);
  const double cosine =
      (up - east * light_east - north * light_north) / std::sqrt(1 + east * east + north * north);
  return std::max(0.0, cosine);
}

using Band = std::vector<std::uint8_t>;

struct Image {
  Picture picture;
  std::vector<Band> bands;  // grey and alpha, or red, green, blue and alpha
};

Image shade(const Ground& ground, const HillshadeOptions& options) {
  Image image{ground.picture, std::vector<Band>(2, Band(ground.elevations.size()))};
  std::size_t i = 0;
  for (int r = 0; r < ground.picture.height; ++r) {
    for (int c = 0; c < ground.picture.width; ++c, ++i) {
      if (std::isnan(ground.elevations[i])) continue;
      image.bands[0][i] =
          static_cast<std::uint8_t>(std::lround(1 + 254 * brightness(ground, c, r, options)));
      image.bands[1][i] = 255;
    }
  }
  return image;
}

DatasetHandle in_memory(const Picture& picture, int bands) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  DatasetHandle dataset(
      driver->Create("", picture.width, picture.height, bands, GDT_Byte, nullptr));
  if (!dataset) throw DemError("not enough memory for the picture" + gdal_message());
  const MapBox& b = picture.box;
  double transform[] = {b[0], (b[2] - b[0]) / picture.width, 0, b[3],
                        0,    (b[1] - b[3]) / picture.height};
  dataset->SetGeoTransform(transform);
  return dataset;
}

void write_png(const Image& image, const fs::path& png) {
  const int count = static_cast<int>(image.bands.size());
  const int width = image.picture.width, height = image.picture.height;
  const DatasetHandle memory = in_memory(image.picture, count);
  const QuietGdal quiet;
  for (int b = 0; b < count; ++b) {
    Band band = image.bands[static_cast<std::size_t>(b)];
    const CPLErr result = memory->GetRasterBand(b + 1)->RasterIO(
        GF_Write, 0, 0, width, height, band.data(), width, height, GDT_Byte, 0, 0, nullptr);
    if (result != CE_None) throw DemError("the picture can't be drawn" + gdal_message());
  }
  memory->GetRasterBand(count)->SetColorInterpretation(GCI_AlphaBand);
  const fs::path temporary = png.string() + ".tmp";
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("PNG");
  const DatasetHandle written(driver->CreateCopy(temporary.c_str(), memory.get(), FALSE, nullptr,
                                                 GDALDummyProgress, nullptr));
  if (!written) throw DemError("can't write " + png.string() + gdal_message());
  fs::rename(temporary, png);
}

// 255 where a geometry covers a pixel.
Band mask_of(const Picture& picture, const std::vector<GeometryHandle>& geometries) {
  const DatasetHandle memory = in_memory(picture, 1);
  std::vector<OGRGeometryH> handles;
  handles.reserve(geometries.size());
  for (const GeometryHandle& g : geometries) handles.push_back(OGRGeometry::ToHandle(g.get()));
  const std::vector<double> burn(handles.size(), 255);
  int band = 1;
  const QuietGdal quiet;
  CPLErr result = CE_None;
  if (!handles.empty()) {
    result = GDALRasterizeGeometries(GDALDataset::ToHandle(memory.get()), 1, &band,
                                     static_cast<int>(handles.size()), handles.data(), nullptr,
                                     nullptr, burn.data(), nullptr, nullptr, nullptr);
  }
  Band mask(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
  if (result == CE_None) {
    result = memory->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, picture.width, picture.height,
                                                mask.data(), picture.width, picture.height,
                                                GDT_Byte, 0, 0, nullptr);
  }
  if (result != CE_None) throw DemError("the zones can't be drawn" + gdal_message());
  return mask;
}

void paint(Image& image, const Band& mask, const std::array<int, 3>& colour, double cover) {
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] == 0) continue;
    for (std::size_t b = 0; b < 3; ++b) {
      image.bands[b][i] = static_cast<std::uint8_t>(
          std::lround((1 - cover) * image.bands[b][i] + cover * colour[b]));
    }
    image.bands[3][i] = 255;
  }
}

std::vector<GeometryHandle> areas_of(const std::vector<Zone>& zones, ZoneKind kind) {
  std::vector<GeometryHandle> areas;
  for (const Zone& zone : zones) {
    if (zone.kind == kind) areas.push_back(to_ogr(zone.area));
  }
  return areas;
}

}  // namespace

Picture write_hillshade(const Dem& dem, const fs::path& png, const HillshadeOptions& options) {
  const Image image = shade(read_ground(dem, options), options);
  write_png(image, png);
  return image.picture;
}

Picture write_zone_picture(const Dem& dem, const std::vector<Zone>& zones,
                           const std::vector<MapLine>& lines, const fs::path& png,
                           const HillshadeOptions& options) {
  Image image = shade(read_ground(dem, options), options);
  const Band grey = image.bands[0], alpha = image.bands[1];
  image.bands = {grey, grey, grey, alpha};
  paint(image, mask_of(image.picture, areas_of(zones, ZoneKind::runout)), {253, 174, 97}, 0.6);
  paint(image, mask_of(image.picture, areas_of(zones, ZoneKind::release)), {215, 48, 39}, 0.5);
  std::vector<GeometryHandle> drawn;
  drawn.reserve(lines.size());
  for (const MapLine& line : lines) drawn.push_back(to_ogr(line));
  paint(image, mask_of(image.picture, drawn), {30, 80, 200}, 0.9);
  write_png(image, png);
  return image.picture;
}

}  // namespace leda::profiles
