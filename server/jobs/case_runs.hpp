#pragma once
// Cases run in a folder of their own each, as `leda simulate` leaves them: what `leda study` and
// `leda ensemble` are made of. A run that stands there already is not run again.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "server/documents/case_file.hpp"
#include "server/jobs/executors/executor.hpp"
#include "server/jobs/take_in.hpp"

namespace leda::server {

struct CaseRun {
  std::string name;   ///< of the run, and of its folder
  nlohmann::json of;  ///< a case file without faults
};

struct CaseRunEnd {
  std::optional<SectionResult> result;
  std::string reason;  ///< why there is no result
};

struct RunsProgress {
  std::size_t runs = 0, done = 0, running = 0;
  std::size_t found = 0;  ///< of those done: they stood in the folder
};

/// "3 of 12 runs done (1 found), 2 running"
std::string text_of(const RunsProgress& progress);

struct RunsListener {
  std::function<void(const RunsProgress&)> progress;  ///< when a run began or ended
  std::function<bool()> interrupted;                  ///< true ends the runs
};

struct CaseRunEnds {
  std::vector<CaseRunEnd> runs;  ///< in the order they were asked for
  bool interrupted = false;      ///< then some runs have no result
};

/// Runs what is missing, in their order. A result counts when it is whole, of the same case and of
/// this version of Leda; what fails is told in its run and tried again by the next call.
/// @param folder gets a folder for each run
/// @param fields of runs that stood, and of those that are run
/// @throws std::runtime_error naming the file that could not be written
CaseRunEnds run_cases(const std::vector<CaseRun>& runs, const std::filesystem::path& folder,
                      Fields fields, Executor& executor, const RunsListener& listener);

}  // namespace leda::server
