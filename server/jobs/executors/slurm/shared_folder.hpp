#pragma once
// Run folders where the nodes of a cluster reach them, while the store stays on a local disk:
// SQLite's write-ahead log does not work on a network file system.

#include <filesystem>

namespace leda::server {

/// Makes `data`/runs a link to `shared`/runs, and `shared` this data folder's own. Changes nothing
/// where that is so already.
/// @throws DataFolderError where runs stand in `data` itself, or `shared` is another data folder's
void put_runs_in(const std::filesystem::path& data, const std::filesystem::path& shared);

}  // namespace leda::server
