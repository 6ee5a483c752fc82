#include "server/documents/ensemble_case.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "server/documents/json_syntax.hpp"
#include "server/documents/published_schema.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

void check_finer_cell(const EnsembleCase& ensemble, const std::string& at, FaultList& faults) {
  const auto& check = ensemble.asked.plan.check;
  const double cell = ensemble.of.settings.resolution.cell_m;
  if (!check || !check->cell_m) return;
  faults.within(at + "/check/cell_m", *check->cell_m, *check->cell_m < cell,
                "finer than the case's " + show(cell) + " m");
}

/// What is wrong with members: told once a place, of the first one, with how many it are.
class FaultsOfMembers {
 public:
  FaultsOfMembers(const EnsembleCase& ensemble, const std::string& at)
      : ensemble_(ensemble), at_(at) {}

  void look_at(const MemberRun& run) {
    for (const Fault& fault : read_case_file(ensemble_.case_of(run)).faults) {
      const auto input = ensemble_.document.input_at(fault.pointer);
      std::string place = at_;
      if (input) place = fmt::format("{}/inputs/{}/distribution", at_, *input);
      if (run.finer) place = at_ + "/check/cell_m";
      Told& told = by_place_[place];
      if (told.count++ == 0) told.text = text_of(run, fault, input);
    }
  }

  void tell(FaultList& faults) const {
    for (const auto& [place, told] : by_place_) {
      const std::string more =
          told.count == 1 ? "" : fmt::format(" (and {} more like it)", told.count - 1);
      faults.add(place, told.text + more);
    }
  }

 private:
  struct Told {
    std::string text;
    std::size_t count = 0;
  };

  std::string text_of(const MemberRun& run, const Fault& fault,
                      std::optional<std::size_t> input) const {
    const std::string what =
        input ? "draws " + show(ensemble_.inputs_of(run.member)[*input]) + ", with which "
              : "cannot be run: ";
    return fmt::format("{} {}{} {}", run_name(run), what, fault.pointer, fault.message);
  }

  const EnsembleCase& ensemble_;
  const std::string& at_;
  std::map<std::string, Told> by_place_;
};

void check_members(const EnsembleCase& ensemble, const std::string& at, FaultList& faults) {
  FaultsOfMembers found(ensemble, at);
  for (const MemberRun& run :
       member_runs(ensemble.asked.plan, 0, ensemble.asked.plan.stop.max_members)) {
    if (run.repeat == 0) found.look_at(run);  // others differ from these by their seed
  }
  found.tell(faults);
}

}  // namespace

std::string run_name(const MemberRun& run) {
  std::string name = fmt::format("member-{}", run.member);
  if (run.repeat > 0) name += fmt::format("-seed-{}", run.repeat);
  return run.finer ? name + "-finer" : name;
}

std::vector<MemberRun> member_runs(const solver::EnsemblePlan& plan, std::size_t from,
                                   std::size_t before) {
  std::vector<MemberRun> runs;
  for (std::size_t member = from; member < before; ++member) {
    runs.push_back({member});
    if (!plan.check || member >= plan.check->members) continue;
    for (std::size_t repeat = 1; repeat < plan.check->seeds; ++repeat) {
      runs.push_back({member, repeat});
    }
    if (plan.check->cell_m) runs.push_back({member, 0, true});
  }
  return runs;
}

std::vector<double> EnsembleCase::inputs_of(std::size_t member) const {
  return draws.inputs_of(place(), member);
}

Resolution EnsembleCase::resolution_of(const MemberRun& run) const {
  Resolution resolution = of.settings.resolution;
  resolution.seed = draws.particle_seed(place(), run.member, run.repeat);
  if (run.finer) resolution.cell_m = asked.plan.check->cell_m.value();
  return resolution;
}

json EnsembleCase::case_of(const MemberRun& run) const {
  json document_of_run = document.with(inputs_of(run.member));
  const Resolution resolution = resolution_of(run);
  document_of_run["name"] = of.section.name + " " + run_name(run);
  document_of_run["resolution"]["seed"] = resolution.seed;
  if (run.finer) document_of_run["resolution"]["cell_m"] = resolution.cell_m;
  document_of_run.erase("output");
  return document_of_run;
}

Parsed<EnsembleCase> read_ensemble_case(const json& document, const std::string& case_at,
                                        const json& ensemble, const std::string& ensemble_at,
                                        Members members) {
  FaultList list;
  EnsembleRequest asked = read_ensemble(ensemble, ensemble_at, list);
  if (asked.raster_cell_m) {
    list.add(ensemble_at + "/raster", "belongs to a region: a case has no map");
  }
  UncertainDocument uncertain(document, asked.places, ensemble_at, list);
  auto of = read_case_file(document, case_at);
  auto faults = list.take();
  if (faults.empty()) faults = schema_faults(PublishedSchema::ensemble, ensemble, ensemble_at);
  add_new_faults(faults, std::move(of.faults));
  if (!faults.empty()) return {std::nullopt, std::move(faults)};
  const auto& plan = asked.plan;
  auto draws = solver::Draws::make(plan.inputs, plan.correlations, plan.sampling,
                                   plan.stop.min_members, plan.stop.max_members);
  EnsembleCase read{std::move(*of.value), std::move(asked), std::move(uncertain),
                    std::move(draws.value())};
  check_finer_cell(read, ensemble_at, list);
  if (members == Members::checked) check_members(read, ensemble_at, list);
  faults = list.take();
  if (!faults.empty()) return {std::nullopt, std::move(faults)};
  return {std::move(read), {}};
}

Parsed<EnsembleCase> parse_ensemble_case(std::string_view text) {
  auto parsed = parse_json(text);
  if (!parsed) return {std::nullopt, std::move(parsed.faults)};
  json& document = *parsed.value;
  if (!document.is_object() || !document.contains("ensemble")) {
    return {std::nullopt, {{"/ensemble", "is missing: a case without it is run by leda simulate"}}};
  }
  const json ensemble = document["ensemble"];
  document.erase("ensemble");
  return read_ensemble_case(document, "", ensemble, "/ensemble");
}

}  // namespace leda::server
