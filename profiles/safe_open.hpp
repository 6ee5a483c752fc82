#pragma once
// Opening a raster that came from outside. Private to profiles/.

#include <filesystem>
#include <string>

#include "profiles/dem.hpp"
#include "profiles/gdal_handle.hpp"

namespace leda::profiles {

/// Opens a file read-only with the drivers for elevation grids and nothing else.
/// @throws DemError where it isn't a plain file, no such grid, too large, or has several bands
DatasetHandle open_safely(const std::filesystem::path& file, const DemLimits& limits);

/// The projected CRS of a raster; several ways of saying the same end up as one EPSG code.
/// @throws DemError where there is none, it is in degrees, or it is not a known one
OGRSpatialReference horizontal_crs(GDALDataset& dataset, int stated_epsg, int& epsg);

/// "m", "ft" or "us-ft": as stated, else as the band says, else as the vertical CRS says, else
/// metres where the horizontal unit is the metre.
/// @throws DemError where that leaves it open
std::string vertical_unit(GDALDataset& dataset, const std::string& stated);

/// @throws DemError for anything but "m", "ft", "us-ft"
double metres_per_vertical_unit(const std::string& unit);

}  // namespace leda::profiles
