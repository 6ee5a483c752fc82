#pragma once
// One run in its folder: case in, progress while it goes, fields, profile and result out.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "disk/whole_file.hpp"
#include "solver/run/simulate.hpp"
#include "solver/section/section_result.hpp"
#include "solver/section/validate.hpp"

namespace leda::server {

enum class ExitCode {
  result = 0,
  failure = 1,
  invalid = 2,
  unstable = 3,
  interrupted = 4,
  disk_full = 5,     ///< or a quota used up; what stands is sound
  out_of_memory = 6  ///< more was asked for than the run may use
};

struct RunOptions {
  std::function<void(const solver::Progress&)> progress;  ///< beside progress.json
  std::function<bool()> interrupted;                      ///< true ends the run
  std::function<void(const std::string&)> say;            ///< lines for the log
  double checkpoint_interval_s = 10;                      ///< of the wall clock
  /// Leaves the last checkpoint beside the result, so that a result that turns out damaged costs
  /// no more than the steps since then. Whoever takes the result in removes it.
  bool keep_checkpoint = false;
  Precision precision = Precision::single_precision;  ///< as in RunSettings
  bool ground_rests = true;                           ///< as in RunSettings
  int threads = 1;                                    ///< the result is the same for any number
};

struct RunOutcome {
  ExitCode code = ExitCode::failure;
  std::vector<Fault> faults;            ///< where code is invalid
  std::optional<SectionResult> result;  ///< where one was written
};

/// Runs a case and writes progress.json (several times a second, always whole), fields.h5,
/// view.pvd where the case asks for it, profile_after.csv and, last, result.json. An interrupted
/// run leaves no result.json. An invalid case changes nothing. A checkpoint in the folder that is
/// of this case, version and way of computing is gone on from, another one is refused with a line
/// to `say`. Throws std::runtime_error naming the file when one cannot be written, std::bad_alloc.
RunOutcome run_case(std::string_view case_text, const std::filesystem::path& folder,
                    const RunOptions& options = {});

}  // namespace leda::server
