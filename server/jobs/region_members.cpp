#include "server/jobs/region_members.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "profiles/build_section.hpp"
#include "server/documents/member_faults.hpp"
#include "server/jobs/request_pointers.hpp"
#include "server/layers/job_ensemble.hpp"
#include "server/layers/region_quantiles.hpp"

namespace leda::server {
namespace {

using db::SectionRecord;
using nlohmann::json;

/// Pointers of the ensemble's document are those of the request within its inputs.
std::vector<Fault> within_inputs(std::vector<Fault> faults) {
  constexpr std::string_view inputs = "/inputs";
  for (Fault& fault : faults) {
    if (fault.pointer.starts_with(inputs)) fault.pointer.erase(0, inputs.size());
  }
  return faults;
}

/// A section that is named as a member of another will be: "AA' member-3".
void refuse_names_of_members(const std::vector<SectionRecord>& sections, FaultList& faults) {
  std::set<std::string> names;
  for (const SectionRecord& section : sections) names.insert(section.name);
  for (const std::string& name : names) {
    const std::size_t end = name.rfind(" member-");
    if (end != std::string::npos && names.contains(name.substr(0, end))) {
      faults.add("/inputs/sections", "has \"" + name + "\", which a member of \"" +
                                         name.substr(0, end) +
                                         "\" may be named: give it another name");
    }
  }
}

/// The record that a member of a section will have.
SectionRecord as_member(const SectionRecord& section, const MemberRun& run) {
  SectionRecord member = section;
  member.member = member_of(section, run);
  return member;
}

}  // namespace

Parsed<CaseFile> RegionMembers::read_case(const SectionRecord& member, const json& request) const {
  const MemberRun run = run_of(member);
  const solver::Place place = place_of(member, request_.soil);
  auto ground = request_.ensemble->ground_of(place, run.member);
  if (!ground) return {std::nullopt, std::move(ground.faults)};
  auto built = profiles::build_section(profile_of(member), ground.value->soil);
  CaseFile of;
  of.settings = std::move(ground.value->settings);
  const Resolution drawn = request_.ensemble->resolution_of(place, run);
  of.settings.resolution.seed = drawn.seed;
  if (run.finer) of.settings.resolution.cell_m = drawn.cell_m;
  of.settings.output = Output{};
  auto faults = faults_of(built, of.settings, request);
  of.section = std::move(built.section);
  if (!faults.empty()) return {std::nullopt, within_inputs(std::move(faults))};
  return {std::move(of), {}};
}

std::vector<Fault> RegionMembers::check(const std::vector<SectionRecord>& sections,
                                        const json& request) const {
  std::vector<std::size_t> with_members;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    if (sections[i].state == db::SectionState::waiting) with_members.push_back(i);
  }
  const auto runs = member_runs(plan(), 0, plan().stop.max_members);
  const std::size_t every = with_members.size() * runs.size() / most_checked_members + 1;
  const RegionEnsemble& ensemble = *request_.ensemble;
  MemberFaults found(ensemble.document, "/inputs/ensemble");
  for (std::size_t k = 0; k < with_members.size(); ++k) {
    const SectionRecord& section = sections[with_members[k]];
    const solver::Place place = place_of(section, request_.soil);
    // Each section begins elsewhere, so that together they look at every draw they share.
    for (std::size_t i = k % every; i < runs.size(); i += every) {
      if (runs[i].repeat > 0) continue;  // they differ from the member by their seed
      const auto read = read_case(as_member(section, runs[i]), request);
      for (const Fault& fault : read.faults) {
        found.add(section.name + " " + run_name(runs[i]), runs[i].finer,
                  ensemble.inputs_of(place, runs[i].member), fault);
      }
    }
  }
  FaultList list;
  refuse_names_of_members(sections, list);
  found.tell(list);
  return list.take();
}

Parsed<CaseFile> RegionMembers::case_of(const SectionRecord& member) const {
  auto read = read_case(member, json::object());
  if (read) read.value->section.name = member.name;
  return read;
}

std::string RegionMembers::not_needed(const SectionRecord& member) {
  return looks_.not_needed(*request_.ensemble, place_of(member, request_.soil), member);
}

std::vector<Zone> RegionMembers::zones(const std::vector<SectionRecord>& sections,
                                       const profiles::ZonationOptions& options) const {
  auto exceedance = plan().exceedance;
  std::ranges::sort(exceedance);
  const auto quantiles =
      region_quantiles(store_, *request_.ensemble, request_.soil, sections, exceedance);
  return profiles::probability_zones(quantiles, exceedance, options);
}

}  // namespace leda::server
