#include "server/run/run_folder.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "db/result_file.hpp"
#include "db/utc_now.hpp"
#include "db/view_file.hpp"
#include "server/documents/case_file.hpp"
#include "server/documents/result_document.hpp"
#include "server/operate/version.hpp"
#include "server/run/run_checkpoint.hpp"

namespace leda::server {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// progress.json, no more than a few times a second: a run makes thousands of steps in one.
class ProgressFile {
 public:
  explicit ProgressFile(fs::path file) : file_(std::move(file)) {}

  void write(const solver::Progress& progress) {
    const bool same_stage = progress.stage == stage_;
    if (same_stage && Clock::now() - written_ < std::chrono::milliseconds(250)) return;
    stage_ = progress.stage;
    written_ = Clock::now();
    const nlohmann::json document = {{"fraction", progress.fraction},
                                     {"time_s", progress.time_s},
                                     {"stage", progress.stage},
                                     {"updated", db::utc_now()}};
    try {
      disk::write_whole(file_, document.dump() + "\n");
    } catch (const disk::FileError&) {
      // A run does not end because nobody can be told how far it is.
    }
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

/// What has to be the same for a checkpoint to be gone on from: the program, and how it is asked
/// to compute.
std::string computed_by(const RunOptions& options) {
  std::string by = version();
  if (options.precision == Precision::double_precision) by += " in double precision";
  if (!options.ground_rests) by += " without rest";
  return by;
}

/// The files of one run, and the checkpoints that let another process go on with it.
class RunFiles {
 public:
  RunFiles(const CaseFile& run, const std::string& sha256, const fs::path& folder,
           const RunOptions& options)
      : options_(options),
        fields_(folder / "fields.h5", material_names(run.section), sha256, version()),
        progress_(folder / "progress.json"),
        checkpoint_(folder, sha256, computed_by(options)) {
    if (run.settings.output.paraview) view_.emplace(folder);
  }

  /// The listener refers to this object.
  solver::Listener listener() {
    left_ = checkpoint_.read();
    if (!left_.refused.empty()) {
      say("the checkpoint is refused, the run starts anew: " + left_.refused);
    }
    if (left_.state.empty()) checkpoint_.begin();
    solver::Listener listener;
    listener.resume_from = std::move(left_.state);
    listener.resumed = [this](bool taken_up) { taken_up ? go_on() : begin(); };
    listener.checkpoint_interval_s = options_.checkpoint_interval_s;
    listener.checkpoint = [this](const std::string& state, std::int64_t frames) {
      keep(state, frames);
    };
    listener.progress = [this](const solver::Progress& p) {
      progress_.write(p);
      if (options_.progress) options_.progress(p);
    };
    listener.frame = [this](const Frame& frame) {
      show(frame);
      checkpoint_.add(frame);
    };
    listener.interrupted = options_.interrupted;
    return listener;
  }

  void close() {
    fields_.close();
    if (view_) view_->close();
  }

 private:
  void say(const std::string& line) const {
    if (options_.say) options_.say(line);
  }

  void show(const Frame& frame) {
    fields_.append(frame);
    if (view_) view_->append(frame);
  }

  void go_on() {
    checkpoint_.go_on([this](const Frame& frame) { show(frame); });
    say(fmt::format("goes on from its checkpoint, {} frames", left_.frames));
  }

  void begin() {
    checkpoint_.begin();
    say("the checkpoint is refused, the run starts anew: it is no state of this run");
  }

  void keep(const std::string& state, std::int64_t frames) {
    try {
      checkpoint_.keep(state, frames);
    } catch (const disk::FileError& error) {
      // The run itself is sound, and the checkpoint before this one stands.
      say(std::string("no checkpoint: ") + error.what());
    }
  }

  const RunOptions& options_;
  db::ResultFileWriter fields_;
  std::optional<db::ViewWriter> view_;
  ProgressFile progress_;
  RunCheckpoint checkpoint_;
  RunCheckpoint::Left left_;
};

}  // namespace

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
  RunFiles files(*parsed.value, sha256, folder, options);
  RunSettings settings = parsed.value->settings;
  settings.precision = options.precision;
  settings.ground_rests = options.ground_rests;
  SectionResult result =
      solver::simulate(parsed.value->section, settings, files.listener(), options.threads);
  if (result.status == RunStatus::interrupted) {
    outcome.code = ExitCode::interrupted;
    return outcome;
  }
  files.close();
  result.case_sha256 = sha256;
  result.version = version();
  const std::string text = result_text(result);
  // What was written counts: a value that is not finite has turned the result unstable there.
  auto written = parse_result(text);
  if (!written) {
    const Fault& fault = written.faults.front();
    throw std::runtime_error(
        fmt::format("the solver gave an impossible result: {} {}", fault.pointer, fault.message));
  }
  result = std::move(*written.value);
  disk::write_durably(folder / "profile_after.csv", profile_csv(result.profile_after));
  disk::write_durably(folder / "result.json", text);
  if (!options.keep_checkpoint) remove_checkpoint(folder);
  outcome.code = result.status == RunStatus::unstable ? ExitCode::unstable : ExitCode::result;
  outcome.result = std::move(result);
  return outcome;
}

}  // namespace leda::server
