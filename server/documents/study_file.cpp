#include "server/documents/study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "server/documents/execute_options.hpp"
#include "server/documents/json_syntax.hpp"
#include "server/documents/object_reader.hpp"
#include "server/documents/published_schema.hpp"
#include "server/documents/study_grid.hpp"
#include "server/documents/study_setting.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::StudyReference;
using solver::StudySetting;

/// Where the case cannot be read: no value that a study may ask for, so that none equals it.
constexpr StudySetting unknown_setting{0, 0, 0};

/// @param own names tell the time step where it is another
std::string name_of(const AskedSetting& asked, const StudySetting& own) {
  const StudySetting& setting = asked.repeated.setting;
  return setting_name(setting, setting.time_step_factor != own.time_step_factor);
}

/// @return whether the runs are few enough to look at each
bool check_settings(const std::vector<AskedSetting>& asked, const StudySetting& own,
                    const std::string& at, FaultList& faults) {
  std::size_t runs = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    runs += std::size_t(asked[i].repeated.seeds) + 1;
    for (std::size_t j = 0; j < i; ++j) {
      if (asked[i].repeated.setting != asked[j].repeated.setting) continue;
      faults.add(asked[i].at.front(), name_of(asked[i], own) + " is asked for twice");
    }
  }
  if (runs <= most_study_runs) return true;
  faults.add(at, fmt::format("asks for {} runs, must be at most {}", runs, most_study_runs));
  return false;
}

std::optional<StudyReference> read_reference(ObjectReader& reader, FaultList& faults) {
  const json* value = reader.require("reference");
  if (!value || *value == "finest") return std::nullopt;
  const std::string at = reader.at("reference");
  if (!value->is_object()) {
    faults.add(at, "is " + kind_of(*value) +
                       ", must be \"finest\" or an object with retrogression_m, runout_m, source");
    return std::nullopt;
  }
  ObjectReader item(*value, at, faults);
  StudyReference reference;
  const auto distance = [&](const char* key) {
    const auto number = item.optional_number(key);
    if (number && !std::isnan(*number)) faults.positive(item.at(key), *number, "m");
    return number;
  };
  reference.retrogression_m = distance("retrogression_m");
  reference.runout_m = distance("runout_m");
  if (!reference.retrogression_m && !reference.runout_m) {
    faults.add(at, "names no distance: give retrogression_m, runout_m or both");
  }
  reference.source = item.text("source", 500);
  item.refuse_unknown();
  return reference;
}

/// What a setting does to the case is told where the study asks for it. Where the case cannot be
/// read, what settings alone do wrong is told all the same.
void check_against_case(const CaseFile* of, const std::vector<AskedSetting>& asked,
                        const std::string& case_at, FaultList& faults) {
  const StudySetting own = of ? own_setting(*of) : unknown_setting;
  std::set<std::string> told;
  for (const AskedSetting& one : asked) {
    const CaseFile run = case_of(of ? *of : CaseFile{}, {one.repeated.setting, 0, {}, ""});
    for (const Fault& fault :
         of ? validate(run.section, run.settings) : validate_settings(run.settings)) {
      std::string pointer = place_of(one, fault.pointer);
      if (pointer.empty() && !of) continue;
      if (pointer.empty()) pointer = case_at + fault.pointer;
      if (!told.insert(pointer).second) continue;
      faults.add(pointer, fmt::format("{} (cell {})", fault.message, name_of(one, own)));
    }
  }
}

/// The document as a client would send it, for the published schema.
std::vector<Fault> faults_of_schema(json document, const StudyFile& study, const std::string& at) {
  document.erase("workers");
  document.erase("case_file");
  if (!document.contains("case")) document["case"] = to_document(study.of);
  auto faults = schema_faults(PublishedSchema::study_request, {{"inputs", document}});
  for (Fault& fault : faults) {
    constexpr std::string_view inputs = "/inputs";
    if (fault.pointer.starts_with(inputs)) fault.pointer.replace(0, inputs.size(), at);
  }
  return faults;
}

Parsed<StudyFile> read_study(const json& document, const std::string& at,
                             const CaseReader* read_file) {
  FaultList list;
  StudyFile study;
  ObjectReader reader(document, at, list);
  study.name = reader.text("name");
  NamedCase named = read_named_case(reader, read_file, list);
  auto& of = named.of;
  const StudySetting own = of ? own_setting(*of.value) : unknown_setting;
  const auto asked = read_study_grid(reader, own, list);
  const bool few = check_settings(asked, own, at, list);
  for (const AskedSetting& one : asked) study.question.settings.push_back(one.repeated);
  study.question.reference = read_reference(reader, list);
  study.question.wanted_error = reader.number_or("wanted_error", study.question.wanted_error);
  if (const double e = study.question.wanted_error; !std::isnan(e)) {
    list.within(reader.at("wanted_error"), e, e > 0 && e <= 1, "above 0 and at most 1");
  }
  if (read_file) study.workers = read_count(reader, "workers", 1, 1024, list);
  if (const json* machine = reader.find("machine")) {
    study.machine = read_text(*machine, reader.at("machine"), 200, list);
  }
  reader.refuse_unknown();
  if (few) check_against_case(of ? &*of.value : nullptr, asked, named.at, list);
  if (of) study.of = std::move(*of.value);
  auto faults = list.take();
  add_new_faults(faults, std::move(of.faults));
  if (faults.empty()) faults = faults_of_schema(document, study, at);
  if (!faults.empty()) return {std::nullopt, std::move(faults)};
  return {std::move(study), {}};
}

}  // namespace

Parsed<StudyFile> parse_study_file(std::string_view text, const CaseReader& read_case) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  return read_study(*parsed.value, "", &read_case);
}

Parsed<StudyFile> parse_study_request(std::string_view text) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  FaultList list;
  ObjectReader body(*parsed.value, "", list);
  Parsed<StudyFile> result;
  if (const json* inputs = body.require("inputs")) {
    result = read_study(*inputs, "/inputs", nullptr);
  }
  read_execute_options(body, list);
  body.refuse_unknown();
  for (Fault& fault : list.take()) result.faults.push_back(std::move(fault));
  if (!result.faults.empty()) result.value.reset();
  return result;
}

bool tells_time_step(const StudyFile& study) {
  return std::ranges::any_of(study.question.settings, [&](const auto& asked) {
    return asked.setting.time_step_factor != study.of.settings.time_step_factor;
  });
}

}  // namespace leda::server
