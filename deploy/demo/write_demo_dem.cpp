// Writes the demo's DEM: a reconstruction of Sainte-Monique, Quebec, before the landslide of 1994.
// It is no survey. The cross-section is the one the thesis gives in numbers (4.5, 5.4.1, Figure
// 4-5a): bank 21.7 m with a slope of 37 m down to the brook at 5.0 m, an opposite slope of 25 m up
// to 17.0 m, plateaus. The thesis does not say how wide the brook is; 4 m is assumed. The section
// is swept along a gently curving line, also assumed, in MTM zone 8 near the village.
//
// write_demo_dem DEM.tif            the DEM, 1 m, EPSG:2950
// write_demo_dem --lines            the lines of region.json: the brook, AA' and BB'

#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace {

struct Point {
  double x, y;
};

constexpr double west = 380150, south = 5113000;  // m, EPSG:2950
constexpr int columns = 760, rows = 760;          // cells of 1 m
constexpr float nodata = -9999;

// The brook: a sine of 18 m amplitude and 500 m wavelength on an axis turned 20 degrees.
constexpr Point axis_origin{380330, 5113200};
constexpr double axis_angle = 20 * 3.14159265358979323846 / 180;

Point brook_at(double s) {
  const double off = 18 * std::sin(2 * 3.14159265358979323846 * s / 500);
  return {axis_origin.x + s * std::cos(axis_angle) - off * std::sin(axis_angle),
          axis_origin.y + s * std::sin(axis_angle) + off * std::cos(axis_angle)};
}

// Elevation by distance from the middle of the brook: positive towards the bank that slid.
double elevation_at(double distance) {
  constexpr double profile[][2] = {{-27, 17.0}, {-2, 5.0}, {2, 5.0}, {39, 21.7}};
  if (distance <= profile[0][0]) return profile[0][1];
  for (int i = 1; i < 4; ++i) {
    if (distance > profile[i][0]) continue;
    const double share = (distance - profile[i - 1][0]) / (profile[i][0] - profile[i - 1][0]);
    return profile[i - 1][1] + share * (profile[i][1] - profile[i - 1][1]);
  }
  return profile[3][1];
}

// Signed distance to the brook, from the nearest segment of it; positive to its left.
double distance_to_brook(const std::vector<Point>& brook, Point p) {
  double nearest = std::numeric_limits<double>::max();
  double side = 1;
  for (std::size_t i = 1; i < brook.size(); ++i) {
    const Point a = brook[i - 1], b = brook[i];
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double share =
        std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    const double away = std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
    if (away >= nearest) continue;
    nearest = away;
    side = dx * (p.y - a.y) - dy * (p.x - a.x) >= 0 ? 1 : -1;
  }
  return side * nearest;
}

std::vector<float> elevations() {
  std::vector<Point> brook;  // well beyond the edges of the DEM
  for (int s = -600; s <= 1200; s += 4) brook.push_back(brook_at(s));
  std::vector<float> cells;
  cells.reserve(std::size_t{columns} * rows);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Point centre{west + column + 0.5, south + rows - row - 0.5};
      cells.push_back(static_cast<float>(elevation_at(distance_to_brook(brook, centre))));
    }
  }
  return cells;
}

bool write_dem(const std::string& file) {
  GDALRegister_GTiff();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  char tiled[] = "TILED=YES", packed[] = "COMPRESS=DEFLATE", predictor[] = "PREDICTOR=3";
  char* how[] = {tiled, packed, predictor, nullptr};
  const std::string temporary = file + ".tmp";
  GDALDataset* dem = driver->Create(temporary.c_str(), columns, rows, 1, GDT_Float32, how);
  if (!dem) return false;
  OGRSpatialReference crs;
  bool ok = crs.importFromEPSG(2950) == OGRERR_NONE && dem->SetSpatialRef(&crs) == CE_None;
  double transform[] = {west, 1, 0, south + rows, 0, -1};
  ok = ok && dem->SetGeoTransform(transform) == CE_None;
  GDALRasterBand* band = dem->GetRasterBand(1);
  band->SetNoDataValue(nodata);
  band->SetUnitType("m");
  band->SetDescription("ground elevation, a reconstruction of Sainte-Monique");
  std::vector<float> cells = elevations();
  ok = ok && band->RasterIO(GF_Write, 0, 0, columns, rows, cells.data(), columns, rows, GDT_Float32,
                            0, 0, nullptr) == CE_None;
  GDALClose(GDALDataset::ToHandle(dem));
  if (!ok) return false;
  std::filesystem::rename(temporary, file);
  return true;
}

// 183 m of plateau, the slope, the brook, the opposite slope and 57 m of plateau behind it.
void print_section(const char* name, double s) {
  const Point here = brook_at(s), ahead = brook_at(s + 0.01);
  const double step = std::hypot(ahead.x - here.x, ahead.y - here.y);
  const Point left{-(ahead.y - here.y) / step, (ahead.x - here.x) / step};
  std::printf("{\"name\": \"%s\", \"line\": [[%.2f, %.2f], [%.2f, %.2f]]}\n", name,
              here.x + 222 * left.x, here.y + 222 * left.y, here.x - 84 * left.x,
              here.y - 84 * left.y);
}

void print_lines() {
  print_section("AA'", 185);
  print_section("BB'", 285);
  std::printf("{\"along\": [");
  for (int s = 0; s <= 450; s += 25) {
    const Point p = brook_at(s);
    std::printf("%s[%.2f, %.2f]", s > 0 ? ", " : "", p.x, p.y);
  }
  std::printf("], \"spacing_m\": 50, \"upslope_m\": 222, \"downslope_m\": 84}\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_demo_dem DEM.tif | --lines\n";
    return 2;
  }
  if (std::strcmp(argv[1], "--lines") == 0) {
    print_lines();
    return 0;
  }
  if (!write_dem(argv[1])) {
    std::cerr << "write_demo_dem: can't write " << argv[1] << '\n';
    return 1;
  }
  return 0;
}
