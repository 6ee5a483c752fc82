#include "profiles/export_layers.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>

#include <algorithm>
#include <fstream>
#include <vector>

#include "profiles/dem.hpp"
#include "profiles/gdal_error.hpp"
#include "profiles/layer_writer.hpp"
#include "profiles/work_folder.hpp"

namespace leda::profiles {
namespace {

namespace fs = std::filesystem;

void add_to_zip(void* zip, const fs::path& file, const fs::path& zip_file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<char> chunk(std::size_t{1} << 20);
  bool ok = in && CPLCreateFileInZip(zip, file.filename().c_str(), nullptr) == CE_None;
  while (ok && in) {
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    const auto count = static_cast<int>(in.gcount());
    if (count > 0) ok = CPLWriteFileInZip(zip, chunk.data(), count) == CE_None;
  }
  if (!ok || CPLCloseFileInZip(zip) != CE_None) {
    throw ExportError("can't write " + zip_file.string() + gdal_message());
  }
}

void zip_folder(const fs::path& folder, const fs::path& zip_file) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  void* zip = CPLCreateZip(zip_file.c_str(), nullptr);
  if (!zip) throw ExportError("can't write " + zip_file.string() + gdal_message());
  for (const fs::path& file : files) add_to_zip(zip, file, zip_file);
  if (CPLCloseZip(zip) != CE_None) throw ExportError("can't write " + zip_file.string());
}

fs::path write_zip(const RegionLayers& layers, const std::string& ending, const fs::path& work) {
  const fs::path folder = work / "layers";
  fs::path zip_file = work / "layers.zip";
  fs::create_directory(folder);
  write_layer_files(layers, ending, folder);
  zip_folder(folder, zip_file);
  return zip_file;
}

fs::path write(const RegionLayers& layers, ExportFormat format, const fs::path& work) {
  switch (format) {
    case ExportFormat::geopackage:
      write_geopackage(layers, work / "leda.gpkg");
      return work / "leda.gpkg";
    case ExportFormat::geojson:
      write_geojson(layers, work / "leda.geojson");
      return work / "leda.geojson";
    case ExportFormat::shapefile:
      return write_zip(layers, "shp", work);
    case ExportFormat::flatgeobuf:
      break;
  }
  return write_zip(layers, "fgb", work);
}

}  // namespace

std::optional<ExportFormat> export_format_from(const std::string& text) {
  if (text == "gpkg") return ExportFormat::geopackage;
  if (text == "geojson") return ExportFormat::geojson;
  if (text == "shp") return ExportFormat::shapefile;
  if (text == "fgb") return ExportFormat::flatgeobuf;
  return std::nullopt;
}

const char* file_ending(ExportFormat format) {
  switch (format) {
    case ExportFormat::geopackage:
      return ".gpkg";
    case ExportFormat::geojson:
      return ".geojson";
    case ExportFormat::shapefile:
      return ".shp.zip";
    case ExportFormat::flatgeobuf:
      break;
  }
  return ".fgb.zip";
}

const char* media_type(ExportFormat format) {
  switch (format) {
    case ExportFormat::geopackage:
      return "application/geopackage+sqlite3";
    case ExportFormat::geojson:
      return "application/geo+json";
    case ExportFormat::shapefile:
    case ExportFormat::flatgeobuf:
      break;
  }
  return "application/zip";
}

void export_layers(const RegionLayers& layers, ExportFormat format, const fs::path& file) {
  initialize_gdal();
  const QuietGdal quiet;
  const WorkFolder work(file);
  if (!work.exists()) throw ExportError("can't write beside " + file.string());
  try {
    fs::rename(write(layers, format, work.path()), file);
  } catch (const fs::filesystem_error& error) {
    throw ExportError("can't write " + file.string() + ": " + error.code().message());
  }
}

}  // namespace leda::profiles
