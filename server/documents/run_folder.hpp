#pragma once
// One run in its folder: case in, progress while it goes, fields, profile and result out.

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "solver/section/section_result.hpp"
#include "solver/section/validate.hpp"
#include "solver/simulate.hpp"

namespace leda::server {

enum class ExitCode { result = 0, failure = 1, invalid = 2, unstable = 3, interrupted = 4 };

struct RunOptions {
  std::function<void(const solver::Progress&)> progress;  ///< beside progress.json
  std::function<bool()> interrupted;                      ///< true ends the run
};

struct RunOutcome {
  ExitCode code = ExitCode::failure;
  std::vector<Fault> faults;            ///< where code is invalid
  std::optional<SectionResult> result;  ///< where one was written
};

/// Runs a case and writes progress.json (several times a second, always whole), fields.h5,
/// view.pvd where the case asks for it, profile_after.csv and, last, result.json. An interrupted
/// run leaves no result.json. An invalid case changes nothing.
/// Throws std::runtime_error naming the file when one cannot be written.
RunOutcome run_case(std::string_view case_text, const std::filesystem::path& folder,
                    const RunOptions& options = {});

/// Writes a file under a temporary name beside it, then renames: readers see all or nothing.
void write_whole(const std::filesystem::path& file, std::string_view text);

}  // namespace leda::server
