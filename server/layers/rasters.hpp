#pragma once
// DEMs into the data folder: checked, written anew, named.

#include <filesystem>
#include <string>

#include "db/store.hpp"
#include "profiles/register_dem.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {

/// What a file does not say of itself.
struct RegisterOptions {
  profiles::DemOptions dem{};
  profiles::Fills fills = profiles::Fills::look_for;
};

/// Takes a DEM in under a name. The same file under the same name again changes nothing.
/// @throws Problem where the file can't serve as a DEM, the name is not allowed or taken by
///         another DEM, or the DEM has another name already
db::RasterRecord register_raster(const DataFolder& data, db::Store& store,
                                 const std::filesystem::path& file, const std::string& name,
                                 const RegisterOptions& options);

/// The same for a file that brings no name: `name`, or where that is taken, with a part of the id;
/// a DEM that is known already keeps the name it has.
db::RasterRecord register_file(const DataFolder& data, db::Store& store,
                               const std::filesystem::path& file, const std::string& name,
                               const RegisterOptions& options = {});

/// @throws Problem where the name is not allowed or taken, or there is no such raster
db::RasterRecord rename_raster(db::Store& store, const std::string& id, const std::string& name);

/// Removes the file; the raster can be registered again.
/// @throws Problem where an unfinished job needs it, or there is no such raster
void remove_raster(const DataFolder& data, db::Store& store, const std::string& id);

/// The raster of that id or name.
/// @throws Problem where there is none, or it was removed
db::RasterRecord raster_or_problem(const db::Store& store, const std::string& id);

/// Where the picture of a raster is kept once it was asked for. What counts as missing may be said
/// anew of the same cells, and is a part of the name: a picture that is being drawn then is no
/// picture of the raster as it is now.
std::filesystem::path hillshade_file(const DataFolder& data, const db::RasterRecord& raster);

/// What nodata= and --nodata say: a number, or "none" where every value is ground.
/// @throws Problem where it is neither
void read_nodata(const std::string& text, RegisterOptions& options);

/// Letters, digits, blanks and - _ . ( ) from any script; never something that reads like a path.
bool is_raster_name(const std::string& name);
/// @throws Problem where it is none
void refuse_bad_raster_name(const std::string& name);

}  // namespace leda::server
