#include "server/operate/retention.hpp"

#include <chrono>

#include "db/utc_now.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;
using Days = std::chrono::duration<double, std::ratio<86400>>;

std::uintmax_t bytes_in(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(folder, ignored)) {
    if (entry.is_regular_file(ignored)) bytes += entry.file_size(ignored);
  }
  return bytes;
}

void remove_folder(const fs::path& folder, Purged& purged) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  const std::uintmax_t bytes = bytes_in(folder);
  fs::remove_all(folder, error);
  if (error) return;
  ++purged.run_folders;
  purged.bytes += bytes;
}

void remove_exports(const DataFolder& data, const std::string& job, Purged& purged) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(data.exports(), error)) {
    if (!entry.path().filename().string().starts_with(job)) continue;
    const std::uintmax_t bytes = entry.file_size(error);
    if (fs::remove(entry.path(), error)) purged.bytes += bytes;
  }
}

bool is_older(const fs::path& folder, double days) {
  std::error_code error;
  const auto written = fs::last_write_time(folder, error);
  return !error && fs::file_time_type::clock::now() - written > Days(days);
}

/// Left by a server that was killed between making a folder and storing its run.
void remove_strays(const DataFolder& data, const db::Store& store, double days, Purged& purged) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(data.runs(), error)) {
    const bool stray = !store.has_run(entry.path().filename().string());
    if (stray && is_older(entry.path(), days)) remove_folder(entry.path(), purged);
  }
}

void copy_run(const fs::path& from, const fs::path& to, bool with_fields) {
  fs::create_directories(to);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(from, error)) {
    const auto name = entry.path().filename();
    const bool is_field = name == "fields.h5" || name == "view" || name == "view.pvd";
    if (is_field && !with_fields) continue;
    // A worker may rename a file while it is looked at; what it becomes is part of a later copy.
    fs::copy(entry.path(), to / name, fs::copy_options::recursive, error);
  }
}

}  // namespace

Purged purge(const DataFolder& data, db::Store& store, double older_than_days, bool with_jobs) {
  using Clock = std::chrono::system_clock;
  const auto before =
      Clock::now() - std::chrono::duration_cast<Clock::duration>(Days(older_than_days));
  Purged purged;
  for (const auto& job : store.jobs_finished_before(db::utc_text(before))) {
    for (const auto& run : store.run_folders(job)) remove_folder(data.run(run), purged);
    remove_exports(data, job, purged);
    if (with_jobs && store.remove_job(job)) ++purged.jobs;
  }
  remove_strays(data, store, older_than_days, purged);
  return purged;
}

BackedUp back_up(const DataFolder& data, const fs::path& out, bool with_fields) {
  if (fs::exists(out)) {
    throw DataFolderError(out.string() + " exists already: name a folder that does not");
  }
  const fs::path part = out.string() + ".part";
  fs::remove_all(part);
  const DataFolder copy(part);
  // First the store, then the files: a row is only written once its files are in place, so every
  // file that the copied rows speak of exists by now.
  db::back_up(data.store(), copy.store());
  BackedUp done;
  {
    const db::Store rows(copy.store());
    for (const auto& raster : rows.rasters()) {
      fs::copy_file(data.root() / raster.file, copy.root() / raster.file);
      ++done.rasters;
    }
    for (const auto& run : rows.latest_runs()) {
      if (!fs::is_directory(data.run(run))) continue;  // purged
      copy_run(data.run(run), copy.run(run), with_fields);
      ++done.run_folders;
    }
  }
  done.bytes = bytes_in(part);
  fs::rename(part, out);
  return done;
}

}  // namespace leda::server
