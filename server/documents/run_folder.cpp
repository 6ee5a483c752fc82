#include "server/documents/run_folder.hpp"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "db/result_file.hpp"
#include "db/view_file.hpp"
#include "server/documents/case_file.hpp"
#include "server/documents/result_document.hpp"
#include "server/documents/run_checkpoint.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

std::string utc_now() {
  const auto now = std::chrono::system_clock::now();
  const auto seconds = std::chrono::system_clock::to_time_t(now);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900, utc.tm_mon + 1,
                     utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec);
}

/// progress.json, no more than a few times a second: a run makes thousands of steps in one.
class ProgressFile {
 public:
  explicit ProgressFile(fs::path file) : file_(std::move(file)) {}

  void write(const solver::Progress& progress) {
    const bool same_stage = progress.stage == stage_;
    if (same_stage && Clock::now() - written_ < std::chrono::milliseconds(250)) return;
    stage_ = progress.stage;
    written_ = Clock::now();
    write_whole(file_, nlohmann::json{{"fraction", progress.fraction},
                                      {"time_s", progress.time_s},
                                      {"stage", progress.stage},
                                      {"updated", utc_now()}}
                               .dump() +
                           "\n");
  }

 private:
  fs::path file_;
  std::string stage_;
  Clock::time_point written_{};
};

std::vector<std::string> material_names(const Section& section) {
  std::vector<std::string> names;
  for (const auto& [name, material] : section.materials) names.push_back(name);
  return names;
}

SectionResult simulate_into(const CaseFile& run, const std::string& sha256, const fs::path& folder,
                            const RunOptions& options) {
  db::ResultFileWriter fields(folder / "fields.h5", material_names(run.section), sha256,
                              LEDA_VERSION);
  std::optional<db::ViewWriter> view;
  if (run.settings.output.paraview) view.emplace(folder);
  ProgressFile progress(folder / "progress.json");
  RunCheckpoint checkpoint(folder, sha256, LEDA_VERSION);
  const auto show = [&](const Frame& frame) {
    fields.append(frame);
    if (view) view->append(frame);
  };

  solver::Listener listener;
  auto left = checkpoint.read();
  if (left.state.empty()) checkpoint.remove();
  for (const Frame& frame : left.frames) show(frame);
  listener.resume_from = std::move(left.state);
  listener.checkpoint = [&](const std::string& state, std::int64_t frames) {
    checkpoint.keep(state, frames);
  };
  listener.progress = [&](const solver::Progress& p) {
    progress.write(p);
    if (options.progress) options.progress(p);
  };
  listener.frame = [&](const Frame& frame) {
    show(frame);
    checkpoint.add(frame);
  };
  listener.interrupted = options.interrupted;
  SectionResult result = solver::simulate(run.section, run.settings, listener);
  if (result.status == RunStatus::interrupted) return result;
  fields.close();
  if (view) view->close();
  checkpoint.remove();
  return result;
}

}  // namespace

void write_whole(const fs::path& file, std::string_view text) {
  fs::path part = file;
  part += ".part";
  std::ofstream out(part, std::ios::binary | std::ios::trunc);
  out.write(text.data(), std::streamsize(text.size()));
  out.close();
  std::error_code failed;
  if (out) fs::rename(part, file, failed);
  if (out && !failed) return;
  std::error_code ignored;
  fs::remove(part, ignored);
  throw std::runtime_error(fmt::format("{} could not be written", file.string()));
}

RunOutcome run_case(std::string_view case_text, const fs::path& folder, const RunOptions& options) {
  RunOutcome outcome;
  const auto parsed = parse_case_file(case_text);
  if (!parsed) {
    outcome.code = ExitCode::invalid;
    outcome.faults = parsed.faults;
    return outcome;
  }
  fs::create_directories(folder);
  // A result of an earlier run must not stand beside the fields of this one.
  fs::remove(folder / "result.json");
  const std::string sha256 = case_sha256(*parsed.value);
  SectionResult result = simulate_into(*parsed.value, sha256, folder, options);
  if (result.status == RunStatus::interrupted) {
    outcome.code = ExitCode::interrupted;
    return outcome;
  }
  result.case_sha256 = sha256;
  result.version = LEDA_VERSION;
  const std::string text = result_text(result);
  // What was written counts: a value that is not finite has turned the result unstable there.
  auto written = parse_result(text);
  if (!written) {
    const Fault& fault = written.faults.front();
    throw std::runtime_error(
        fmt::format("the solver gave an impossible result: {} {}", fault.pointer, fault.message));
  }
  result = std::move(*written.value);
  write_whole(folder / "profile_after.csv", profile_csv(result.profile_after));
  write_whole(folder / "result.json", text);
  outcome.code = result.status == RunStatus::unstable ? ExitCode::unstable : ExitCode::result;
  outcome.result = std::move(result);
  return outcome;
}

}  // namespace leda::server
