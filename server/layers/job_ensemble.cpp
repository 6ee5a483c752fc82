#include "server/layers/job_ensemble.hpp"

#include <utility>

#include "profiles/place_result.hpp"
#include "profiles/soil_along.hpp"
#include "server/documents/member_warnings.hpp"
#include "server/documents/process_ids.hpp"
#include "server/documents/simulate_request.hpp"
#include "server/layers/summary.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

using db::SectionRecord;
using db::SectionState;

MemberRow row_of(const Ensemble& ensemble, const solver::Place& place,
                 const SectionRecord& member) {
  MemberRow row = row_of(ensemble, place, run_of(member), member.result);
  row.screened_stable = member.state == SectionState::stable;
  return row;
}

}  // namespace

bool has_ended(const SectionRecord& section) {
  return section.state != SectionState::waiting && section.state != SectionState::running;
}

MemberRun run_of(const SectionRecord& member) {
  const db::MemberRecord& record = member.member.value();
  return {static_cast<std::size_t>(record.number), static_cast<std::size_t>(record.repeat),
          record.finer};
}

db::MemberRecord member_of(const SectionRecord& section, const MemberRun& run) {
  return {section.ordinal, section.name, static_cast<int>(run.member), static_cast<int>(run.repeat),
          run.finer};
}

Profile profile_of(const SectionRecord& section) {
  return {
      section.name, section.trace, section.ground, {section.crest, section.toe}, section.warnings};
}

solver::Place place_of(const SectionRecord& section, const std::vector<SoilModel>& soil) {
  const std::string& name = section.member ? section.member->section : section.name;
  if (soil.size() < 2 || section.ground.empty()) return {"", name};
  const auto crest = profiles::point_on_trace(profile_of(section), section.crest.x);
  const auto model = profiles::model_at(crest, soil);
  return {model ? soil[*model].name : "", name};
}

std::optional<Look> last_look(const Ensemble& ensemble, const solver::Place& place,
                              const std::vector<SectionRecord>& members) {
  const auto& plan = ensemble.asked.plan;
  std::optional<Look> last;
  std::vector<MemberRow> rows;
  for (std::size_t n = plan.stop.min_members; n <= plan.stop.max_members; n *= 2) {
    while (rows.size() < members.size() && run_of(members[rows.size()]).member < n) {
      const SectionRecord& member = members[rows.size()];
      if (!has_ended(member)) return last;
      rows.push_back(row_of(ensemble, place, member));
    }
    if (rows.empty() || rows.back().run.member + 1 < n) return last;
    last = Look{n, solver::summarize(plan, members_of(rows))};
    if (last->summary.ending != solver::Ending::more_members) return last;
  }
  return last;
}

JobEnsemble::JobEnsemble(const db::Store& store, std::variant<EnsembleCase, RegionRequest> request)
    : store_(&store), request_(std::move(request)) {}

std::optional<JobEnsemble> JobEnsemble::of(const db::Store& store, const db::JobStatus& job) {
  const bool is_case = job.process == simulate_section_id, is_region = job.process == map_region_id;
  if (!is_case && !is_region) return std::nullopt;
  const auto whole = store.job(job.id);
  if (!whole) return std::nullopt;
  if (is_case) {
    auto request = parse_simulate_request(whole->request, Members::taken);
    if (request && request.value->ensemble) {
      return JobEnsemble(store, std::move(*request.value->ensemble));
    }
  } else {
    auto request = parse_region_request(whole->request, DemNaming::registered_only);
    if (request && request.value->ensemble) return JobEnsemble(store, std::move(*request.value));
  }
  return std::nullopt;
}

const Ensemble& JobEnsemble::asked() const {
  if (const auto* region = std::get_if<RegionRequest>(&request_)) return *region->ensemble;
  return std::get<EnsembleCase>(request_);
}

const std::vector<SoilModel>& JobEnsemble::soil() const {
  static const std::vector<SoilModel> none;
  const auto* region = std::get_if<RegionRequest>(&request_);
  return region != nullptr ? region->soil : none;
}

EnsembleOfSection JobEnsemble::of_section(const SectionRecord& section) const {
  const solver::Place place = place_of(section, soil());
  const auto members = store_->members(section.job, section.ordinal);
  EnsembleOfSection out;
  for (const SectionRecord& member : members) {
    if (!has_ended(member) || member.state == SectionState::left_out) continue;
    out.rows.push_back(row_of(asked(), place, member));
  }
  if (auto look = last_look(asked(), place, members)) {
    weigh(out.rows, look->members);
    auto warnings = warnings_of(section);
    auto of_members = member_lines(out.rows, look->members, warnings);
    out.ensemble = SectionEnsemble{section.name, asked().asked, std::move(look->summary),
                                   std::move(warnings), std::move(of_members)};
  }
  return out;
}

std::vector<SectionEnsemble> ensembles_of(const db::Store& store, const db::JobStatus& job,
                                          const std::vector<SectionRecord>& sections) {
  std::vector<SectionEnsemble> found;
  const auto ensemble = JobEnsemble::of(store, job);
  if (!ensemble) return found;
  for (const SectionRecord& section : sections) {
    auto of_section = ensemble->of_section(section).ensemble;
    if (of_section) found.push_back(std::move(*of_section));
  }
  return found;
}

JobEnsemble ensemble_or_problem(const db::Store& store, const db::JobStatus& job) {
  auto ensemble = JobEnsemble::of(store, job);
  if (!ensemble) throw Problem(Failure::no_such_result, "job " + job.id + " has no ensemble");
  return std::move(*ensemble);
}

}  // namespace leda::server
