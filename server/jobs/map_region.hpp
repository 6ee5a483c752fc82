#pragma once
// The process map-region: from a DEM and a request to zones on the map. The story of a region in
// a few calls; the waiting in between is the dispatcher's.

#include <memory>
#include <string>

#include "server/documents/region_request.hpp"
#include "server/jobs/process.hpp"

namespace leda::server {

/// @throws Problem with every fault of the document, or where its DEM is not registered
std::unique_ptr<Work> open_region(const std::string& request, const Library& library);

}  // namespace leda::server
