#include "server/layers/exports.hpp"

#include <cctype>
#include <mutex>

#include "server/layers/probability_rasters.hpp"
#include "server/layers/region_layers.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

/// "JOB-20260131120000000.gpkg": another one once the job was retried.
std::string name_of(const db::JobStatus& job, const std::string& ending) {
  std::string name = job.id + "-";
  for (const char c : job.finished) {
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) name += c;
  }
  return name + ending;
}

void remove_older(const fs::path& newest, const db::JobStatus& job, const std::string& ending) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(newest.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    const bool older = name.starts_with(job.id) && name.ends_with(ending) && entry.path() != newest;
    if (older) fs::remove(entry.path(), ignored);
  }
}

fs::path style_of(fs::path raster) { return raster.replace_extension(".qml"); }

/// Exports take memory and processor time: one after the other.
std::mutex exporting;

}  // namespace

fs::path export_of(const DataFolder& data, const db::Store& store, const db::JobStatus& job,
                   profiles::ExportFormat format) {
  const std::string ending = profiles::file_ending(format);
  fs::path file = data.exports() / name_of(job, ending);
  const std::lock_guard one_at_a_time(exporting);
  if (fs::exists(file)) return file;
  profiles::export_layers(region_layers(store, job), format, file);
  remove_older(file, job, ending);
  return file;
}

fs::path raster_of(const DataFolder& data, const db::Store& store, const db::JobStatus& job,
                   const std::string& name) {
  const auto kind = raster_kind_from(name);
  if (!kind) {
    throw Problem(Failure::no_such_resource,
                  "there is no raster '" + name + "': known are " + raster_name(ZoneKind::release) +
                      " and " + raster_name(ZoneKind::runout) + ", with .qml for their styles");
  }
  const std::string ending = "-" + raster_name(*kind);
  fs::path file = data.exports() / name_of(job, ending);
  const std::lock_guard one_at_a_time(exporting);
  if (!fs::exists(file)) {
    write_probability_raster(data, store, job, *kind, file);
    remove_older(file, job, ending);
    remove_older(style_of(file), job, "-" + style_of(raster_name(*kind)).string());
  }
  return name.ends_with(".qml") ? style_of(file) : file;
}

}  // namespace leda::server
