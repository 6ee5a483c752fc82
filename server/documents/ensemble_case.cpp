#include "server/documents/ensemble_case.hpp"

#include <fmt/format.h>

#include <utility>

#include "server/documents/json_syntax.hpp"
#include "server/documents/member_faults.hpp"
#include "server/documents/published_schema.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

void check_finer_cell(const Ensemble& ensemble, const std::string& at, FaultList& faults) {
  const auto& check = ensemble.asked.plan.check;
  const double cell = ensemble.resolution.cell_m;
  if (!check || !check->cell_m || !(cell > 0)) return;  // a cell at fault was told
  faults.within(at + "/check/cell_m", *check->cell_m, *check->cell_m < cell,
                "finer than the " + show(cell) + " m of the members");
}

void check_members(const EnsembleCase& ensemble, const std::string& at, FaultList& faults) {
  MemberFaults found(ensemble.document, at);
  for (const MemberRun& run :
       member_runs(ensemble.asked.plan, 0, ensemble.asked.plan.stop.max_members)) {
    if (run.repeat > 0) continue;  // they differ from these by their seed
    for (const Fault& fault : read_case_file(ensemble.case_of(run)).faults) {
      found.add(run_name(run), run.finer, ensemble.inputs_of(run.member), fault);
    }
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

Resolution Ensemble::resolution_of(const solver::Place& place, const MemberRun& run) const {
  Resolution of_run = resolution;
  of_run.seed = draws.particle_seed(place, run.member, run.repeat);
  if (run.finer) of_run.cell_m = asked.plan.check->cell_m.value();
  return of_run;
}

Ensemble drawn(EnsembleRequest asked, UncertainDocument document, const Resolution& given,
               const std::string& at, FaultList& faults) {
  const auto& plan = asked.plan;
  auto draws = solver::Draws::make(plan.inputs, plan.correlations, plan.sampling,
                                   plan.stop.min_members, plan.stop.max_members);
  Ensemble ensemble{std::move(asked), std::move(document), std::move(draws.value()), given};
  check_finer_cell(ensemble, at, faults);
  return ensemble;
}

json EnsembleCase::case_of(const MemberRun& run) const {
  json document_of_run = document.with(inputs_of(run.member));
  const Resolution own = resolution_of(run);
  document_of_run["name"] = of.section.name + " " + run_name(run);
  document_of_run["resolution"]["seed"] = own.seed;
  if (run.finer) document_of_run["resolution"]["cell_m"] = own.cell_m;
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
  const Resolution given = of.value->settings.resolution;
  EnsembleCase read{drawn(std::move(asked), std::move(uncertain), given, ensemble_at, list),
                    std::move(*of.value)};
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
