#include "profiles/proj4_text.hpp"

#include <cpl_conv.h>
#include <ogr_spatialref.h>

#include "profiles/dem.hpp"
#include "profiles/gdal_error.hpp"

namespace leda::profiles {

std::string proj4_text(int epsg) {
  initialize_gdal();
  const QuietGdal quiet;
  OGRSpatialReference crs;
  if (crs.importFromEPSG(epsg) != OGRERR_NONE) return "";
  char* text = nullptr;
  const bool written = crs.exportToProj4(&text) == OGRERR_NONE;
  std::string result = written && text != nullptr ? text : "";
  CPLFree(text);
  return result;
}

}  // namespace leda::profiles
