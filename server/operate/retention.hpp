#pragma once
// What old jobs left is removed; the rest is copied to where it is safe.

#include <cstdint>
#include <filesystem>

#include "db/store.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {

struct Purged {
  std::size_t jobs = 0;  ///< removed themselves
  std::size_t run_folders = 0;
  std::uintmax_t bytes = 0;
};

/// Removes the run folders and exports of jobs that ended longer ago than that, and folders that
/// no job ever knew. Results, profiles and zones stay in the store, unless `with_jobs`.
Purged purge(const DataFolder& data, db::Store& store, double older_than_days, bool with_jobs);

struct BackedUp {
  std::size_t rasters = 0, run_folders = 0;
  std::uintmax_t bytes = 0;
};

/// Copies a data folder as it is at one moment, also while a server works in it; the copy can be
/// served as it is. It appears whole or not at all.
/// @param with_fields also the fields of the runs (fields.h5, view/), most of the bytes
/// @throws DataFolderError where `out` exists, db::StoreError, std::filesystem::filesystem_error
BackedUp back_up(const DataFolder& data, const std::filesystem::path& out, bool with_fields);

}  // namespace leda::server
