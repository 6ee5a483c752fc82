#include "server/layers/exports.hpp"

#include <cctype>
#include <mutex>

#include "server/layers/region_layers.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;

/// "JOB-20260131120000000.gpkg": another one once the job was retried.
std::string name_of(const db::JobRecord& job, profiles::ExportFormat format) {
  std::string name = job.id + "-";
  for (const char c : job.finished) {
    if (std::isdigit(static_cast<unsigned char>(c)) != 0) name += c;
  }
  return name + profiles::file_ending(format);
}

void remove_older(const fs::path& newest, const db::JobRecord& job, profiles::ExportFormat format) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(newest.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    const bool older = name.starts_with(job.id) && name.ends_with(profiles::file_ending(format)) &&
                       entry.path() != newest;
    if (older) fs::remove(entry.path(), ignored);
  }
}

}  // namespace

fs::path export_of(const DataFolder& data, const db::Store& store, const db::JobRecord& job,
                   profiles::ExportFormat format) {
  // Exports take memory and processor time: one after the other.
  static std::mutex exporting;
  fs::path file = data.exports() / name_of(job, format);
  const std::lock_guard one_at_a_time(exporting);
  if (fs::exists(file)) return file;
  profiles::export_layers(region_layers(store, job), format, file);
  remove_older(file, job, format);
  return file;
}

}  // namespace leda::server
