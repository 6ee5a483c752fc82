#include "profiles/probability_raster.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_alg.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "profiles/areas.hpp"
#include "profiles/dem.hpp"
#include "profiles/export_layers.hpp"
#include "profiles/gdal_error.hpp"
#include "profiles/qgis_style.hpp"
#include "profiles/work_folder.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

constexpr double no_section = -9999;

/// Whole cells around the ground that is spoken for, on multiples of the cell.
struct Grid {
  double west = 0, north = 0, cell = 0;
  int width = 0, height = 0;
};

Grid grid_around(const std::vector<MapPolygon>& area, double cell, const fs::path& file) {
  if (area.empty()) throw ExportError("can't write " + file.string() + ": no section has members");
  const GeometryHandle all = to_ogr(area);
  OGREnvelope box;
  all->getEnvelope(&box);
  Grid grid{std::floor(box.MinX / cell) * cell, std::ceil(box.MaxY / cell) * cell, cell, 0, 0};
  const double width = std::ceil((box.MaxX - grid.west) / cell);
  const double height = std::ceil((grid.north - box.MinY) / cell);
  if (width * height > most_raster_cells) {
    throw ExportError(
        fmt::format("can't write {}: it would have {:.3g} cells, more than {:.3g}: "
                    "give ensemble/raster/cell_m a larger cell",
                    file.string(), width * height, most_raster_cells));
  }
  grid.width = static_cast<int>(width);
  grid.height = static_cast<int>(height);
  return grid;
}

DatasetHandle empty(const Grid& grid, const ProbabilityRaster& raster) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  DatasetHandle dataset(driver->Create("", grid.width, grid.height, 1, GDT_Float32, nullptr));
  if (!dataset) throw ExportError("not enough memory for a raster" + gdal_message());
  double transform[] = {grid.west, grid.cell, 0, grid.north, 0, -grid.cell};
  dataset->SetGeoTransform(transform);
  OGRSpatialReference crs;
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  if (crs.importFromEPSG(raster.epsg) != OGRERR_NONE) {
    throw ExportError("EPSG:" + std::to_string(raster.epsg) + " is not known");
  }
  dataset->SetSpatialRef(&crs);
  dataset->SetMetadataItem("TIFFTAG_IMAGEDESCRIPTION", raster.description.c_str());
  GDALRasterBand* band = dataset->GetRasterBand(1);
  band->SetNoDataValue(no_section);
  band->SetDescription(fmt::format("{} probability", to_string(raster.kind)).c_str());
  band->Fill(no_section);
  return dataset;
}

void burn(GDALDataset& dataset, const std::vector<MapPolygon>& area, double value) {
  if (area.empty()) return;
  const GeometryHandle shape = to_ogr(area);
  OGRGeometryH geometry = OGRGeometry::ToHandle(shape.get());
  int band = 1;
  if (GDALRasterizeGeometries(GDALDataset::ToHandle(&dataset), 1, &band, 1, &geometry, nullptr,
                              nullptr, &value, nullptr, nullptr, nullptr) != CE_None) {
    throw ExportError("a raster can't be drawn" + gdal_message());
  }
}

void write_cog(GDALDataset& memory, const fs::path& file) {
  CPLStringList how;
  how.SetNameValue("COMPRESS", "DEFLATE");
  how.SetNameValue("PREDICTOR", "YES");
  how.SetNameValue("OVERVIEW_RESAMPLING", "AVERAGE");
  how.SetNameValue("NUM_THREADS", "1");  // the same bytes on any machine
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("COG");
  if (driver == nullptr) throw ExportError("this GDAL has no COG driver");
  DatasetHandle written(
      driver->CreateCopy(file.c_str(), &memory, FALSE, how.List(), GDALDummyProgress, nullptr));
  if (!written) throw ExportError("can't write " + file.string() + gdal_message());
}

}  // namespace

void write_probability_raster(const ProbabilityRaster& raster, const fs::path& file) {
  initialize_gdal();
  const QuietGdal quiet;
  const DatasetHandle memory = empty(grid_around(raster.spoken_for, raster.cell, file), raster);
  burn(*memory, raster.spoken_for, 0);
  for (const Zone& zone : raster.zones) burn(*memory, zone.area, zone.probability->exceedance);
  const WorkFolder work(file);
  if (!work.exists()) throw ExportError("can't write beside " + file.string());
  const fs::path temporary = work.path() / file.filename();
  write_cog(*memory, temporary);
  fs::path style = file, temporary_style = temporary;
  style.replace_extension(".qml");
  temporary_style.replace_extension(".qml");
  std::ofstream(temporary_style) << qgis_raster_style(raster.kind);
  try {
    fs::rename(temporary_style, style);
    fs::rename(temporary, file);
  } catch (const fs::filesystem_error& error) {
    throw ExportError("can't write " + file.string() + ": " + error.code().message());
  }
}

}  // namespace leda::profiles
