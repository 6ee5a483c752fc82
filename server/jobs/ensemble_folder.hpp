#pragma once
// The runs of an ensemble in a folder: members/member-7/ and so on, each as `leda simulate` leaves
// it. What stands there is not run again.

#include <filesystem>
#include <vector>

#include "server/documents/ensemble_document.hpp"
#include "server/jobs/case_runs.hpp"

namespace leda::server {

struct EnsembleRuns {
  std::vector<MemberRow> rows;        ///< in the order of member_runs()
  std::vector<std::string> failures;  ///< "member-7: the worker died of signal 9"
  /// Absent where it was interrupted.
  std::optional<solver::EnsembleSummary> summary;
};

/// Runs members and their check until the plan's rule ends it, looking at each doubling.
/// @param fields Fields::removed leaves case.json and result.json of each run
/// @throws std::runtime_error naming the file that could not be written
EnsembleRuns run_ensemble(const EnsembleCase& ensemble, const std::filesystem::path& folder,
                          Fields fields, Executor& executor, const RunsListener& listener);

}  // namespace leda::server
