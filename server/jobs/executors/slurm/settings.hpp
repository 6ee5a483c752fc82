#pragma once
// How Leda uses a Slurm cluster: what differs from site to site.

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace leda::server {

struct SlurmSettings {
  std::string partition;              ///< empty: the site's default
  std::string account;                ///< empty: the user's default
  std::vector<std::string> options;   ///< further ones of sbatch, e.g. "--constraint=avx512"
  std::size_t max_array_size = 1001;  ///< MaxArraySize of slurm.conf: indices stay below it
  std::size_t most_queued = 20'000;   ///< runs handed to Slurm at the same time
  std::size_t most_running = 0;       ///< of one array at the same time; 0: as many as fit
  /// leda as the nodes know it; reached by the same path on each of them.
  std::filesystem::path program;
  /// Where run folders stand, mounted under the same path on each node; empty: the data folder.
  std::filesystem::path shared_folder;
  /// JobCompLoc of jobcomp/filetxt, where this machine can read it; empty: it can't.
  std::filesystem::path completion_file;
  std::chrono::milliseconds look_every{5000};  ///< at the queue
  /// Runs submitted within this time of each other share an array.
  std::chrono::milliseconds gather{500};
  /// How long the files of a run that ended may take to show in the shared folder.
  std::chrono::milliseconds settle{30'000};
  std::chrono::milliseconds patience{60'000};  ///< with one command of Slurm
};

/// Everything that can't work, each with what would be right.
std::vector<std::string> faults_of(const SlurmSettings& settings);

}  // namespace leda::server
