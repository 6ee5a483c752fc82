#include "server/layers/rasters.hpp"

#include <algorithm>
#include <cctype>
#include <memory>

#include "profiles/register_dem.hpp"
#include "server/http/problem.hpp"

namespace leda::server {
namespace {

/// A file that is removed unless it found its place.
struct Temporary {
  explicit Temporary(std::filesystem::path name) : file(std::move(name)) {}
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
  }
  std::filesystem::path file;
};

db::RasterRecord record_of(const profiles::RegisteredDem& dem) {
  db::RasterRecord record;
  record.id = "dem-" + dem.sha256.substr(0, 12);
  record.file = "rasters/" + record.id + ".tif";
  record.sha256 = dem.sha256;
  record.epsg = dem.info.epsg;
  record.cell_x = dem.info.cell_x;
  record.cell_y = dem.info.cell_y;
  record.width = dem.info.width;
  record.height = dem.info.height;
  record.box = dem.info.box;
  record.vertical_unit = dem.info.vertical_unit;
  record.created = db::utc_now();
  return record;
}

/// A DEM that was read whole and written anew, not in its place yet.
struct Checked {
  std::unique_ptr<Temporary> written;
  db::RasterRecord record;
};

Checked check(const DataFolder& data, const std::filesystem::path& file,
              const profiles::DemOptions& options) {
  Checked checked{std::make_unique<Temporary>(data.uploads() / (random_hex(16) + ".tif")), {}};
  try {
    checked.record = record_of(profiles::register_dem(file, checked.written->file, options));
  } catch (const profiles::DemError& error) {
    throw Problem(Failure::invalid_request, error.what());
  }
  return checked;
}

/// First the file, then the row.
db::RasterRecord put_in_place(const DataFolder& data, db::Store& store, const Checked& checked,
                              const std::string& name) {
  db::RasterRecord record = checked.record;
  record.name = name;
  std::filesystem::rename(checked.written->file, data.root() / record.file);
  store.add_raster(record);
  return record;
}

}  // namespace

bool is_raster_name(const std::string& name) {
  if (name.empty() || name.size() > 100 || name.front() == ' ' || name.back() == ' ') return false;
  if (name.find("..") != std::string::npos || name.starts_with("dem-")) return false;
  return std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return c >= 0x80 || std::isalnum(c) != 0 ||
           std::string_view(" -_.()'").find(static_cast<char>(c)) != std::string_view::npos;
  });
}

void refuse_bad_raster_name(const std::string& name) {
  if (is_raster_name(name)) return;
  throw Problem(Failure::invalid_parameter,
                "name: give 1 to 100 letters, digits, blanks and - _ . ( ) ', not starting with "
                "dem-");
}

db::RasterRecord register_raster(const DataFolder& data, db::Store& store,
                                 const std::filesystem::path& file, const std::string& name,
                                 const profiles::DemOptions& options) {
  refuse_bad_raster_name(name);
  const Checked checked = check(data, file, options);
  const auto by_id = store.raster(checked.record.id);
  if (by_id && by_id->name == name) return *by_id;
  if (by_id) {
    throw Problem(Failure::name_taken,
                  "this DEM is registered already as '" + by_id->name + "' (" + by_id->id + ")");
  }
  if (const auto other = store.raster(name)) {
    throw Problem(Failure::name_taken, "the name '" + name + "' is taken by " + other->id);
  }
  return put_in_place(data, store, checked, name);
}

db::RasterRecord register_file(const DataFolder& data, db::Store& store,
                               const std::filesystem::path& file, const std::string& name) {
  const Checked checked = check(data, file, {});
  if (const auto known = store.raster(checked.record.id)) return *known;
  const std::string free_name =
      store.raster(name) ? name + " " + checked.record.sha256.substr(0, 6) : name;
  return put_in_place(data, store, checked, free_name);
}

}  // namespace leda::server
