#include "server/layers/rasters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <memory>
#include <mutex>

#include "disk/new_file.hpp"
#include "disk/temporary_file.hpp"
#include "profiles/register_dem.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

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
  record.lowest_m = dem.lowest_m;
  record.highest_m = dem.highest_m;
  record.share_without_data = 1 - dem.share_with_data;
  if (dem.cell_ground_m) {
    record.cell_ground_x_m = (*dem.cell_ground_m)[0];
    record.cell_ground_y_m = (*dem.cell_ground_m)[1];
  }
  if (dem.fill) record.undeclared_fill_m = dem.fill->value_m;
  record.warnings = dem.warnings;
  return record;
}

/// A DEM that was read whole and written anew, not in its place yet.
struct Checked {
  std::unique_ptr<disk::TemporaryFile> written;
  db::RasterRecord record;
};

Checked check(const DataFolder& data, const std::filesystem::path& file,
              const RegisterOptions& options) {
  Checked checked{std::make_unique<disk::TemporaryFile>(data.uploads() / (random_hex(16) + ".tif")),
                  {}};
  try {
    checked.record = record_of(
        profiles::register_dem(file, checked.written->path(), options.dem, options.fills));
  } catch (const profiles::DemError& error) {
    throw Problem(Failure::invalid_request, data.without_root(error.what()));
  }
  return checked;
}

/// The raster of an id that was not removed.
std::optional<db::RasterRecord> standing(const db::Store& store, const std::string& id) {
  auto raster = store.raster(id);
  if (raster && !raster->removed.empty()) raster.reset();
  return raster;
}

/// Held while it is looked up what stands under a name or an id, and that is changed: two
/// registrations at once would both find the name free.
std::mutex& names_and_files() {
  static std::mutex one;
  return one;
}

constexpr const char* hillshade_ending = ".hillshade.png";

void remove_hillshades(const DataFolder& data, const std::string& id) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(data.rasters(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(id) && name.ends_with(hillshade_ending)) {
      std::filesystem::remove(entry.path(), ignored);
    }
  }
}

/// First the file, brought to the disk, then the row.
db::RasterRecord put_in_place(const DataFolder& data, db::Store& store, const Checked& checked,
                              const std::string& name) {
  db::RasterRecord record = checked.record;
  record.name = name;
  disk::rename_durably(checked.written->path(), data.root() / record.file);
  remove_hillshades(data, record.id);
  store.add_raster(record);
  return record;
}

}  // namespace

std::filesystem::path hillshade_file(const DataFolder& data, const db::RasterRecord& raster) {
  std::string name = raster.id;
  if (raster.undeclared_fill_m) name += fmt::format("-without-{}", *raster.undeclared_fill_m);
  return data.rasters() / (name + hillshade_ending);
}

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
                                 const RegisterOptions& options) {
  refuse_bad_raster_name(name);
  const Checked checked = check(data, file, options);
  const std::lock_guard alone(names_and_files());
  const auto by_id = standing(store, checked.record.id);
  if (by_id && by_id->name == name) {
    // What counts as missing may be said anew of the same cells.
    const bool same = by_id->undeclared_fill_m == checked.record.undeclared_fill_m;
    return same ? *by_id : put_in_place(data, store, checked, name);
  }
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
                               const std::filesystem::path& file, const std::string& name,
                               const RegisterOptions& options) {
  const Checked checked = check(data, file, options);
  const std::lock_guard alone(names_and_files());
  if (const auto known = standing(store, checked.record.id)) {
    const bool same = known->undeclared_fill_m == checked.record.undeclared_fill_m;
    return same ? *known : put_in_place(data, store, checked, known->name);
  }
  const std::string free_name =
      store.raster(name) ? name + " " + checked.record.sha256.substr(0, 6) : name;
  return put_in_place(data, store, checked, free_name);
}

db::RasterRecord raster_or_problem(const db::Store& store, const std::string& id) {
  auto raster = standing(store, id);
  if (!raster) throw Problem(Failure::no_such_resource, "there is no raster '" + id + "'");
  return *raster;
}

db::RasterRecord rename_raster(db::Store& store, const std::string& id, const std::string& name) {
  const std::lock_guard alone(names_and_files());
  const auto raster = raster_or_problem(store, id);
  refuse_bad_raster_name(name);
  const auto other = store.raster(name);
  if (other && other->id != raster.id) {
    throw Problem(Failure::name_taken, "the name '" + name + "' is taken by " + other->id);
  }
  store.rename_raster(raster.id, name);
  return raster_or_problem(store, raster.id);
}

void remove_raster(const DataFolder& data, db::Store& store, const std::string& id) {
  const std::lock_guard alone(names_and_files());
  const auto raster = raster_or_problem(store, id);
  if (!store.remove_raster(raster.id)) {
    throw Problem(Failure::wrong_state, "an unfinished job stands on raster '" + raster.name +
                                            "': wait for its end, or dismiss it");
  }
  // First the row, then the files: what is left over does no harm.
  std::error_code ignored;
  std::filesystem::remove(data.root() / raster.file, ignored);
  remove_hillshades(data, raster.id);
}

void read_nodata(const std::string& text, RegisterOptions& options) {
  if (text.empty()) return;
  if (text == "none") {
    options.fills = profiles::Fills::all_ground;
    return;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) {
    throw Problem(Failure::invalid_parameter,
                  "nodata is '" + text + "': give the number that missing cells hold, or none");
  }
  options.dem.nodata = value;
}

}  // namespace leda::server
