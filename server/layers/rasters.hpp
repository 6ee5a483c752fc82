#pragma once
// DEMs into the data folder: checked, written anew, named.

#include <filesystem>
#include <string>

#include "db/store.hpp"
#include "profiles/dem.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {

/// Takes a DEM in under a name. The same file under the same name again changes nothing.
/// @throws Problem where the file can't serve as a DEM, the name is not allowed or taken by
///         another DEM, or the DEM has another name already
db::RasterRecord register_raster(const DataFolder& data, db::Store& store,
                                 const std::filesystem::path& file, const std::string& name,
                                 const profiles::DemOptions& options);

/// The same for a file that brings no name: `name`, or where that is taken, with a part of the id;
/// a DEM that is known already keeps the name it has.
db::RasterRecord register_file(const DataFolder& data, db::Store& store,
                               const std::filesystem::path& file, const std::string& name);

/// Letters, digits, blanks and - _ . ( ) from any script; never something that reads like a path.
bool is_raster_name(const std::string& name);
/// @throws Problem where it is none
void refuse_bad_raster_name(const std::string& name);

}  // namespace leda::server
