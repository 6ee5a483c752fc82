#pragma once
// Owners of what GDAL hands out. Private to profiles/.

#include <gdal_priv.h>
#include <ogr_geometry.h>

#include <memory>

namespace leda::profiles {

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(GDALDataset::ToHandle(dataset)); }
};
using DatasetHandle = std::unique_ptr<GDALDataset, CloseDataset>;

struct DestroyGeometry {
  void operator()(OGRGeometry* geometry) const { OGRGeometryFactory::destroyGeometry(geometry); }
};
using GeometryHandle = std::unique_ptr<OGRGeometry, DestroyGeometry>;

}  // namespace leda::profiles
