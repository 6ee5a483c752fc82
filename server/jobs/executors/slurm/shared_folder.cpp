#include "server/jobs/executors/slurm/shared_folder.hpp"

#include "server/operate/data_folder.hpp"
#include "server/run/run_folder.hpp"

namespace leda::server {

namespace fs = std::filesystem;

namespace {

void claim(const fs::path& shared, const fs::path& data) {
  const auto owner = shared / "owner";
  if (!fs::exists(owner)) disk::write_whole(owner, data.string() + "\n");
  if (read_whole(owner) == data.string() + "\n") return;
  throw DataFolderError("the shared folder " + shared.string() +
                        " belongs to another data folder, named in " + owner.string() +
                        ": give each its own, or correct that file after a move");
}

}  // namespace

void put_runs_in(const fs::path& data, const fs::path& shared) {
  fs::create_directories(data);
  const fs::path target = fs::canonical(shared) / "runs";
  const fs::path runs = fs::canonical(data) / "runs";
  claim(target.parent_path(), runs.parent_path());
  fs::create_directories(target);
  if (fs::is_symlink(runs) && fs::read_symlink(runs) == target) return;
  const bool empty = !fs::is_symlink(runs) && fs::is_directory(runs) && fs::is_empty(runs);
  if (empty) fs::remove(runs);
  if (fs::is_symlink(runs) || fs::exists(runs)) {
    throw DataFolderError(runs.string() + " holds runs: move what is in it to " + target.string() +
                          " and remove it, then start again");
  }
  fs::create_directory_symlink(target, runs);
}

}  // namespace leda::server
