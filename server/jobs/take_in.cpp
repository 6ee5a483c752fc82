#include "server/jobs/take_in.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "db/result_file.hpp"
#include "server/documents/case_file.hpp"
#include "server/documents/result_document.hpp"
#include "server/operate/data_folder.hpp"

namespace leda::server {
namespace {

std::string first_of(const std::vector<Fault>& faults) {
  return faults.empty() ? "" : faults.front().pointer + " " + faults.front().message;
}

/// The head of the file alone: its numbers carry checksums, and tell of damage when they are read.
std::string fault_of_fields(const std::filesystem::path& file, const std::string& case_sha256) {
  if (!std::filesystem::exists(file)) return "fields.h5 is missing";
  try {
    const auto origin = db::read_result_file_origin(file);
    return origin.case_sha256 == case_sha256 ? "" : "fields.h5 is of another case";
  } catch (const std::runtime_error&) {
    return "fields.h5 is cut off or damaged";
  }
}

}  // namespace

Outcome read_outcome(const std::filesystem::path& run_folder, Fields fields) {
  Outcome outcome;
  try {
    outcome.document = read_whole(run_folder / "result.json");
    const auto result = parse_result(outcome.document);
    const auto run_case = parse_case_file(read_whole(run_folder / "case.json"));
    if (!result) {
      outcome.fault = "result.json: " + first_of(result.faults);
    } else if (!run_case) {
      outcome.fault = "case.json: " + first_of(run_case.faults);
    } else if (result.value->case_sha256 != case_sha256(*run_case.value)) {
      outcome.fault = "result.json is of another case";
    } else {
      if (fields == Fields::kept) {
        outcome.fault = fault_of_fields(run_folder / "fields.h5", result.value->case_sha256);
      }
      if (outcome.fault.empty()) outcome.result = *result.value;
    }
  } catch (const DataFolderError&) {
    outcome.fault = "the run left no result";
  }
  return outcome;
}

double read_fraction(const std::filesystem::path& run_folder) {
  std::ifstream in(run_folder / "progress.json");
  const auto document = nlohmann::json::parse(in, nullptr, false);
  if (!document.is_object() || !document.contains("fraction")) return 0;
  const auto& fraction = document["fraction"];
  return fraction.is_number() ? std::clamp(fraction.get<double>(), 0.0, 1.0) : 0;
}

std::string last_words(const std::filesystem::path& run_folder) {
  std::ifstream in(run_folder / "log.txt");
  std::string line, last;
  while (std::getline(in, line)) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  std::replace_if(
      last.begin(), last.end(), [](unsigned char c) { return c < ' '; }, ' ');
  return last.substr(0, 400);
}

}  // namespace leda::server
