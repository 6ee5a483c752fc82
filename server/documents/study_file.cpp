#include "server/documents/study_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "server/documents/execute_options.hpp"
#include "server/documents/json_syntax.hpp"
#include "server/documents/object_reader.hpp"
#include "server/documents/published_schema.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::StudyReference;
using solver::StudySetting;

constexpr std::array particle_counts{1, 4, 9, 16, 25};
constexpr std::size_t most_values = 20;
constexpr int most_seeds = 50;
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A setting, and where the document asks for its cell size.
struct Asked {
  StudySetting setting;
  std::string cell_at;
};

void check_particles(const std::string& at, double count, FaultList& faults) {
  if (std::isnan(count)) return;
  if (std::ranges::find(particle_counts, count) != particle_counts.end()) return;
  faults.add(at, "is " + show(count) + ", must be one of 1, 4, 9, 16, 25");
}

/// A list of different numbers; those at fault are NaN.
std::vector<double> read_numbers(ObjectReader& reader, const char* key, FaultList& faults) {
  const json* value = reader.require(key);
  if (!value) return {};
  const std::string at = reader.at(key);
  if (!value->is_array() || value->empty() || value->size() > most_values) {
    faults.add(at, fmt::format("is {}, must be a list of 1 to {} numbers",
                               value->is_array() ? fmt::format("a list of {}", value->size())
                                                 : kind_of(*value),
                               most_values));
    return {};
  }
  std::vector<double> numbers;
  for (std::size_t i = 0; i < value->size(); ++i) {
    const std::string here = fmt::format("{}/{}", at, i);
    const double number = read_number((*value)[i], here, faults);
    if (std::ranges::find(numbers, number) != numbers.end()) {
      faults.add(here, "is " + show(number) + " again: every value once");
      numbers.push_back(not_a_number);  // keeps the places of those after it
      continue;
    }
    numbers.push_back(number);
  }
  return numbers;
}

int read_count(ObjectReader& reader, const char* key, int absent, int most, FaultList& faults) {
  const std::int64_t count = reader.integer_or(key, absent);
  if (count <= most) return int(count);
  faults.add(reader.at(key), fmt::format("is {}, must be at most {}", count, most));
  return absent;
}

void read_also(ObjectReader& reader, int seeds, std::vector<Asked>& asked, FaultList& faults) {
  const json* value = reader.find("also");
  if (!value) return;
  const std::string at = reader.at("also");
  if (!value->is_array() || value->size() > most_values) {
    faults.add(at, fmt::format("must be a list of at most {} settings", most_values));
    return;
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    ObjectReader item((*value)[i], fmt::format("{}/{}", at, i), faults);
    if (!item.is_object()) continue;
    const double cell = item.number("cell_m");
    faults.positive(item.at("cell_m"), cell, "m");
    const double particles = item.number("particles_per_cell");
    check_particles(item.at("particles_per_cell"), particles, faults);
    const int own_seeds = read_count(item, "seeds", seeds, most_seeds, faults);
    item.refuse_unknown();
    if (!(cell > 0) || !(particles >= 1 && particles <= 25)) continue;
    asked.push_back({{cell, int(particles), own_seeds}, item.at("cell_m")});
  }
}

std::vector<Asked> read_settings_of_study(ObjectReader& reader, FaultList& faults) {
  const auto cells = read_numbers(reader, "cell_m", faults);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!std::isnan(cells[i])) {
      faults.positive(fmt::format("{}/{}", reader.at("cell_m"), i), cells[i], "m");
    }
  }
  const auto particles = read_numbers(reader, "particles_per_cell", faults);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    check_particles(fmt::format("{}/{}", reader.at("particles_per_cell"), i), particles[i], faults);
  }
  const int seeds = read_count(reader, "seeds", 3, most_seeds, faults);
  std::vector<Asked> asked;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (const double count : particles) {
      if (!(cells[i] > 0) || !(count >= 1 && count <= 25)) continue;
      asked.push_back(
          {{cells[i], int(count), seeds}, fmt::format("{}/{}", reader.at("cell_m"), i)});
    }
  }
  read_also(reader, seeds, asked, faults);
  return asked;
}

void check_settings(const std::vector<Asked>& asked, const std::string& at, FaultList& faults) {
  std::size_t runs = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    runs += std::size_t(asked[i].setting.seeds) + 1;
    for (std::size_t j = 0; j < i; ++j) {
      const auto &a = asked[i].setting, &b = asked[j].setting;
      if (a.cell_m != b.cell_m || a.particles_per_cell != b.particles_per_cell) continue;
      faults.add(asked[i].cell_at, fmt::format("{} m with {} particles a cell is asked for twice",
                                               show(a.cell_m), a.particles_per_cell));
    }
  }
  if (runs > most_study_runs) {
    faults.add(at, fmt::format("asks for {} runs, must be at most {}", runs, most_study_runs));
  }
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

/// What a resolution does to the case, too many particles for example, is told of its cell size.
void check_resolutions(const StudyFile& study, const std::vector<Asked>& asked,
                       const std::string& case_at, FaultList& faults) {
  std::set<std::string> told;
  for (const Asked& one : asked) {
    const CaseFile run =
        case_of(study, {one.setting.cell_m, one.setting.particles_per_cell, std::uint64_t{0}});
    for (const Fault& fault : validate(run.section, run.settings)) {
      const bool of_resolution = fault.pointer.starts_with("/resolution");
      const std::string pointer = of_resolution ? one.cell_at : case_at + fault.pointer;
      if (told.insert(pointer).second) {
        faults.add(pointer, fmt::format("{} (cell {} m, {} particles)", fault.message,
                                        show(one.setting.cell_m), one.setting.particles_per_cell));
      }
    }
  }
}

/// The case of the study, from itself or from the file it names.
/// @param case_at becomes the place of its faults
Parsed<CaseFile> read_case(ObjectReader& reader, const CaseReader* read_file, std::string& case_at,
                           FaultList& faults) {
  case_at = reader.at("case");
  const json* file = read_file ? reader.find("case_file") : nullptr;
  if (!file) {
    const json* document = reader.require("case");
    return document ? read_case_file(*document, case_at) : Parsed<CaseFile>{};
  }
  case_at = reader.at("case_file");
  if (reader.find("case")) faults.add(case_at, "stands beside case: give one of the two");
  const std::string name = read_text(*file, case_at, 4096, faults);
  if (name.empty()) return {};
  const auto text = (*read_file)(name);
  if (!text) {
    faults.add(case_at, "is \"" + name + "\", which cannot be read");
    return {};
  }
  auto parsed = parse_case_file(*text);
  for (Fault& fault : parsed.faults) {
    fault.message.insert(0, fmt::format("{} {}: ", name, fault.pointer));
    fault.pointer = case_at;
  }
  return parsed;
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
  std::string case_at;
  auto of = read_case(reader, read_file, case_at, list);
  const auto asked = read_settings_of_study(reader, list);
  check_settings(asked, at, list);
  for (const Asked& one : asked) study.question.settings.push_back(one.setting);
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
  if (of) {
    study.of = std::move(*of.value);
    check_resolutions(study, asked, case_at, list);
  }
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

CaseFile case_of(const StudyFile& study, const Resolution& resolution) {
  CaseFile run = study.of;
  run.settings.resolution = resolution;
  run.settings.output = Output{};
  return run;
}

std::string run_name(const Resolution& r) {
  return fmt::format("cell-{}-particles-{}-seed-{}", r.cell_m, r.particles_per_cell, r.seed);
}

}  // namespace leda::server
