#pragma once
// The files that results are exported to, each made once.

#include <filesystem>
#include <string>

#include "db/store.hpp"
#include "profiles/export_layers.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {

/// Sections and zones of a finished job as a file under exports/. Made where it is missing; a
/// retried job gets a new one. Safe to call from several threads.
/// @throws Problem wrong_state where the job has no map
std::filesystem::path export_of(const DataFolder& data, const db::Store& store,
                                const db::JobStatus& job, profiles::ExportFormat format);

/// release_probability.tif or runout_probability.tif of a finished job, with its style beside it.
/// @param name of the raster, or of the style
/// @throws Problem where the job has no ensemble or no map, or there is no such file
std::filesystem::path raster_of(const DataFolder& data, const db::Store& store,
                                const db::JobStatus& job, const std::string& name);

}  // namespace leda::server
