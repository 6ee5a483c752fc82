#include "server/documents/hindcast_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "server/documents/execute_options.hpp"
#include "server/documents/json_syntax.hpp"
#include "server/documents/member_faults.hpp"
#include "server/documents/observed_reader.hpp"
#include "server/documents/published_schema.hpp"

namespace leda::server {
namespace {

using nlohmann::json;
using solver::HindcastRun;
using solver::SharedDraws;

/// A past slide as read; its case may be at fault.
struct ReadSlide {
  solver::PastSlide slide;
  std::string source;
  NamedCase named;
};

ReadSlide read_slide(const json& value, const std::string& at, const CaseReader* read_file,
                     FaultList& faults) {
  ObjectReader reader(value, at, faults);
  ReadSlide read;
  read.slide.name = reader.text("name", 100);
  read.named = read_named_case(reader, read_file, faults);
  if (read.named.of) read.slide.least_m = read.named.of.value->settings.resolution.cell_m;
  if (const json* observed = reader.require("observed")) {
    read_observed(*observed, reader.at("observed"), read.slide, faults);
  }
  if (const json* source = reader.find("source")) {
    read.source = read_text(*source, reader.at("source"), 1000, faults);
  }
  reader.refuse_unknown();
  return read;
}

std::vector<ReadSlide> read_slides(ObjectReader& reader, const CaseReader* read_file,
                                   FaultList& faults) {
  std::vector<ReadSlide> slides;
  const json* list = reader.require("events");
  const std::string at = reader.at("events");
  if (list == nullptr) return slides;
  if (!list->is_array() || list->empty() || list->size() > most_past_slides) {
    faults.add(at, (list->is_array() ? fmt::format("has {} items", list->size())
                                     : "is " + kind_of(*list)) +
                       fmt::format(", must be a list of 1 to {} past slides", most_past_slides));
    return slides;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string here = fmt::format("{}/{}", at, i);
    ReadSlide read = read_slide((*list)[i], here, read_file, faults);
    const auto same = [&](const auto& other) { return other.slide.name == read.slide.name; };
    if (!read.slide.name.empty() && std::ranges::any_of(slides, same)) {
      faults.add(here + "/name", "is \"" + read.slide.name + "\", which another slide has already");
    }
    slides.push_back(std::move(read));
  }
  return slides;
}

/// The inputs and their correlations; members are drawn and ended as the hindcast says.
EnsembleRequest read_uncertain(const json& value, const std::string& at, FaultList& faults) {
  EnsembleRequest request = read_ensemble(value, at, faults);
  for (const char* key : {"sampling", "stop", "check", "exceedance", "raster"}) {
    if (value.is_object() && value.contains(key)) {
      faults.add(at + "/" + key,
                 "means nothing to a hindcast, which draws its members in waves: leave it out");
    }
  }
  const auto& inputs = request.plan.inputs;
  const bool shared = std::ranges::any_of(
      inputs, [](const auto& input) { return input.scope == solver::Scope::region; });
  if (!inputs.empty() && !shared) {
    faults.add(
        at + "/inputs",
        "has no input of the scope region: slides share nothing, so that nothing is learned");
  }
  return request;
}

std::size_t read_number_of(ObjectReader& reader, const char* key, std::size_t absent,
                           std::size_t least, std::size_t most, FaultList& faults) {
  const std::int64_t count = reader.integer_or(key, std::int64_t(absent));
  if (count >= std::int64_t(least) && count <= std::int64_t(most)) return std::size_t(count);
  faults.add(reader.at(key), fmt::format("is {}, must be {} to {}", count, least, most));
  return absent;
}

void read_waves(ObjectReader& reader, std::size_t slides, solver::HindcastPlan& plan,
                FaultList& faults) {
  auto& draws = plan.draws;
  draws.members = read_number_of(reader, "members", 64, 16, most_members, faults);
  draws.locals = read_number_of(reader, "locals", 4, 1, 16, faults);
  plan.waves = read_number_of(reader, "waves", 2, 1, 5, faults);
  const std::int64_t seed = reader.integer_or("seed", 1);
  if (seed < 0) faults.add(reader.at("seed"), fmt::format("is {}, must be at least 0", seed));
  draws.seed = std::uint64_t(seed);
  const double absent = std::min(50.0, 0.5 * static_cast<double>(draws.members));
  plan.least_effective = reader.number_or("least_effective_members", absent);
  if (const double n = plan.least_effective; !std::isnan(n)) {
    faults.within(reader.at("least_effective_members"), n,
                  n >= 2 && n <= static_cast<double>(draws.members),
                  "at least 2 and at most members, " + std::to_string(draws.members));
  }
  plan.confidence = reader.number_or("confidence", plan.confidence);
  if (const double c = plan.confidence; !std::isnan(c)) {
    faults.within(reader.at("confidence"), c, c >= 0.5 && c <= 0.999,
                  "at least 0.5 and at most 0.999");
  }
  const std::size_t runs = draws.members * draws.locals * plan.waves * slides;
  if (runs > most_hindcast_runs) {
    faults.add(reader.at("members"),
               fmt::format("makes {} runs with {} slides, {} local draws and {} waves, must be at "
                           "most {}",
                           runs, slides, draws.locals, plan.waves, most_hindcast_runs));
  }
}

/// Where inputs lead in the case of each slide; faults name the slide.
std::vector<PastCase> open_cases(std::vector<ReadSlide>& slides, const EnsembleRequest& asked,
                                 const std::string& at, FaultList& faults) {
  std::vector<PastCase> cases;
  for (ReadSlide& read : slides) {
    if (!read.named.of) continue;  // told
    FaultList own;
    UncertainDocument document(read.named.document, asked.places, at, own);
    for (Fault& fault : own.take()) {
      faults.add(std::move(fault.pointer), "at " + read.slide.name + ": " + fault.message);
    }
    cases.push_back({std::move(*read.named.of.value), std::move(document), std::move(read.source)});
  }
  return cases;
}

void check_first_wave(const HindcastFile& file, const std::string& at, FaultList& faults) {
  const SharedDraws draws(file.plan.draws);
  for (std::size_t e = 0; e < file.cases.size(); ++e) {
    MemberFaults found(file.cases[e].document, at);
    for (std::size_t local = 0; local < file.plan.draws.locals; ++local) {
      for (const HindcastRun& run : runs_of_draw(file.plan, 0, local)) {
        if (run.slide != e) continue;
        const std::string name = "at " + file.slide(run) + ", " + run_name(file.plan.draws, run);
        for (const Fault& fault : read_case_file(file.case_of(draws, run)).faults) {
          found.add(name, false, file.inputs_of(draws, run), fault);
        }
      }
    }
    found.tell(faults);
  }
}

/// The document as a client would send it, for the published schema.
std::vector<Fault> faults_of_schema(json document, const HindcastFile& file,
                                    const std::string& at) {
  for (std::size_t e = 0; e < file.cases.size(); ++e) {
    json& event = document["events"][e];
    event.erase("case_file");
    event["case"] = file.cases[e].document.given();
  }
  auto faults = schema_faults(PublishedSchema::hindcast_request, {{"inputs", document}});
  for (Fault& fault : faults) {
    constexpr std::string_view inputs = "/inputs";
    if (fault.pointer.starts_with(inputs)) fault.pointer.replace(0, inputs.size(), at);
  }
  return faults;
}

Parsed<HindcastFile> read_hindcast(const json& document, const std::string& at,
                                   const CaseReader* read_file, Members members) {
  FaultList list;
  ObjectReader reader(document, at, list);
  HindcastFile file;
  file.name = reader.text("name");
  auto slides = read_slides(reader, read_file, list);
  EnsembleRequest asked;
  const std::string ensemble_at = reader.at("ensemble");
  if (const json* value = reader.require("ensemble")) {
    asked = read_uncertain(*value, ensemble_at, list);
    if (value->is_object()) file.inputs = value->value("inputs", json::array());
  }
  if (const json* value = reader.find("discrepancy")) {
    file.plan.discrepancy = read_discrepancy(*value, reader.at("discrepancy"), list);
  }
  read_waves(reader, slides.size(), file.plan, list);
  reader.refuse_unknown();
  file.plan.draws.inputs = std::move(asked.plan.inputs);
  file.plan.draws.correlations = std::move(asked.plan.correlations);
  std::vector<Fault> of_cases;
  for (ReadSlide& read : slides) {
    file.plan.slides.push_back(read.slide);
    for (Fault& fault : read.named.of.faults) of_cases.push_back(std::move(fault));
  }
  file.cases = open_cases(slides, asked, ensemble_at, list);
  file.places = std::move(asked.places);
  auto faults = list.take();
  add_new_faults(faults, std::move(of_cases));
  if (faults.empty()) faults = faults_of_schema(document, file, at);
  if (faults.empty() && members == Members::checked) {
    FaultList of_members;
    check_first_wave(file, ensemble_at, of_members);
    faults = of_members.take();
  }
  if (!faults.empty()) return {std::nullopt, std::move(faults)};
  return {std::move(file), {}};
}

}  // namespace

const std::string& HindcastFile::slide(const HindcastRun& run) const {
  return plan.slides.at(run.slide).name;
}

std::vector<double> HindcastFile::inputs_of(const SharedDraws& draws,
                                            const HindcastRun& run) const {
  return draws.inputs_of(run, slide(run));
}

json HindcastFile::case_of(const SharedDraws& draws, const HindcastRun& run) const {
  json document = cases.at(run.slide).document.with(inputs_of(draws, run));
  document["name"] = slide(run) + " " + run_name(plan.draws, run);
  document["resolution"]["seed"] = draws.particle_seed(run, slide(run));
  document.erase("output");
  return document;
}

std::string run_name(const solver::SharedPlan& plan, const HindcastRun& run) {
  std::string name = fmt::format("wave-{}-slide-{}-member-{}", run.member / plan.members + 1,
                                 run.slide + 1, run.member);
  if (run.local > 0) name += fmt::format("-local-{}", run.local + 1);
  return name;
}

std::vector<HindcastRun> runs_of_draw(const solver::HindcastPlan& plan, std::size_t wave,
                                      std::size_t local) {
  std::vector<HindcastRun> runs;
  const std::size_t members = plan.draws.members;
  for (std::size_t member = wave * members; member < (wave + 1) * members; ++member) {
    for (std::size_t slide = 0; slide < plan.slides.size(); ++slide) {
      runs.push_back({slide, member, local});
    }
  }
  return runs;
}

Parsed<HindcastFile> parse_hindcast_file(std::string_view text, const CaseReader& read_case) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  return read_hindcast(*parsed.value, "", &read_case, Members::checked);
}

Parsed<HindcastFile> parse_hindcast_request(std::string_view text, Members members) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  FaultList list;
  ObjectReader body(*parsed.value, "", list);
  Parsed<HindcastFile> result;
  if (const json* inputs = body.require("inputs")) {
    result = read_hindcast(*inputs, "/inputs", nullptr, members);
  }
  read_execute_options(body, list);
  body.refuse_unknown();
  for (Fault& fault : list.take()) result.faults.push_back(std::move(fault));
  if (!result.faults.empty()) result.value.reset();
  return result;
}

}  // namespace leda::server
