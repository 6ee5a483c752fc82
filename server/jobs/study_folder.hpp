#pragma once
// The runs of a study in a folder: runs/cell-0.75-particles-4-seed-1/ and so on.

#include <filesystem>
#include <vector>

#include "server/documents/study_file.hpp"
#include "server/jobs/case_runs.hpp"

namespace leda::server {

struct StudyRuns {
  std::vector<solver::StudyRun> runs;  ///< in the order of solver::study_runs()
  bool interrupted = false;            ///< then some runs have no result
};

/// Runs what is missing, as run_cases().
/// @throws std::runtime_error naming the file that could not be written
StudyRuns run_study(const StudyFile& study, const std::filesystem::path& folder, Executor& executor,
                    const RunsListener& listener);

}  // namespace leda::server
