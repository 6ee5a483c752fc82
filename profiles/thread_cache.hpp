#pragma once
// Transformations of coordinates: each thread keeps its own.

#include <ogr_spatialref.h>

#include <map>
#include <memory>

namespace leda::profiles {

/// What the calling thread keeps for an EPSG code; empty at first. To make a transformation asks
/// PROJ's database, some 12 ms, and PROJ's objects belong to the thread that made them.
template <class Kept>
std::shared_ptr<const Kept>& kept_by_thread(int epsg) {
  // GDAL has a PROJ context for each thread and asks for it whenever a system is destroyed. Asked
  // once before the map stands, it outlives the map; else the map's end would make another, which
  // nobody frees.
  thread_local auto kept = [] {
    static_cast<void>(OGRSpatialReference());
    return std::map<int, std::shared_ptr<const Kept>>();
  }();
  return kept[epsg];
}

}  // namespace leda::profiles
