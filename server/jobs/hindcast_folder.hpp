#pragma once
// The runs of a hindcast in a folder: members/wave-1-slide-2-member-7/ and so on, each as
// `leda simulate` leaves it. What stands there is not run again.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "server/documents/hindcast_document.hpp"
#include "server/jobs/case_runs.hpp"

namespace leda::server {

struct HindcastRuns {
  solver::SharedDraws draws;
  std::vector<HindcastRow> rows;      ///< of all waves, in their order
  std::vector<std::string> failures;  ///< "wave-1-slide-2-member-7: the worker died of signal 9"
  /// Absent where it was interrupted.
  std::optional<solver::HindcastSummary> summary;
};

/// Runs waves until enough members are effective or the plan's waves are spent.
/// @param before_wave is told the number of each wave, from 1, when it begins; may be empty
/// @throws std::runtime_error naming the file that could not be written
HindcastRuns run_hindcast(const HindcastFile& file, const std::filesystem::path& folder,
                          Fields fields, Executor& executor, const RunsListener& listener,
                          const std::function<void(std::size_t)>& before_wave);

}  // namespace leda::server
