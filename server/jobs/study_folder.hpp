#pragma once
// The runs of a study in a folder: runs/cell-0.75-particles-4-seed-1/ and so on, each as `leda
// simulate` leaves it. A run that stands there already is not run again.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "server/documents/study_file.hpp"
#include "server/jobs/executors/executor.hpp"

namespace leda::server {

struct StudyProgress {
  std::size_t runs = 0, done = 0, running = 0;
  std::size_t found = 0;  ///< of those done: they stood in the folder
};

struct StudyListener {
  std::function<void(const StudyProgress&)> progress;  ///< several times a second
  std::function<bool()> interrupted;                   ///< true ends the study
};

struct StudyRuns {
  std::vector<solver::StudyRun> runs;  ///< in the order of solver::study_runs()
  bool interrupted = false;            ///< then some runs have no result
};

/// Runs what is missing. A result counts when it is whole, of the same case and of this version of
/// Leda; what fails is told in its run and tried again by the next call.
/// @throws std::runtime_error naming the file that could not be written
StudyRuns run_study(const StudyFile& study, const std::filesystem::path& folder, Executor& executor,
                    const StudyListener& listener);

}  // namespace leda::server
