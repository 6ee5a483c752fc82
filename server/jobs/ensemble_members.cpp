#include "server/jobs/ensemble_members.hpp"

#include <fmt/format.h>

#include "server/layers/job_ensemble.hpp"

namespace leda::server {
namespace {

using db::SectionRecord;

SectionRecord member_record(const SectionRecord& section, const MemberRun& run) {
  SectionRecord record;
  record.job = section.job;
  record.name = section.name + " " + run_name(run);
  record.member = member_of(section, run);
  return record;
}

/// The largest look that a member is not part of; 0: it is part of the first.
std::size_t look_before(std::size_t member, const solver::EnsemblePlan& plan) {
  std::size_t look = 0;
  for (std::size_t n = plan.stop.min_members; n <= member; n *= 2) look = n;
  return look;
}

}  // namespace

void add_members(std::vector<SectionRecord>& sections, const solver::EnsemblePlan& plan) {
  const std::size_t number = sections.size();
  std::size_t from = 0;
  for (std::size_t n = plan.stop.min_members; n <= plan.stop.max_members; from = n, n *= 2) {
    const auto runs = member_runs(plan, from, n);
    for (std::size_t i = 0; i < number; ++i) {
      if (sections[i].state != db::SectionState::waiting) continue;
      for (const MemberRun& run : runs) {
        auto record = member_record(sections[i], run);
        record.ordinal = static_cast<int>(sections.size());
        sections.push_back(std::move(record));
      }
    }
  }
}

bool is_beyond_first_look(const SectionRecord& section, const solver::EnsemblePlan& plan) {
  return section.member && run_of(section).member >= plan.stop.min_members;
}

Resolution resolution_of(const SectionRecord& section, const Resolution& given,
                         const std::optional<solver::CheckRule>& check) {
  Resolution resolution = given;
  if (section.member && section.member->finer) resolution.cell_m = check->cell_m.value();
  return resolution;
}

std::string EnsembleLooks::not_needed(const Ensemble& ensemble, const solver::Place& place,
                                      const SectionRecord& member) {
  const std::size_t number = run_of(member).member;
  OfSection& of = by_section_[member.member->of];
  if (!of.ended_at && look_before(number, ensemble.asked.plan) > of.looked_at) {
    look(ensemble, place, member, of);
  }
  if (!of.ended_at || number < *of.ended_at) return "";
  return fmt::format("not needed: {} members are sure enough", *of.ended_at);
}

void EnsembleLooks::look(const Ensemble& ensemble, const solver::Place& place,
                         const SectionRecord& member, OfSection& of) const {
  if (of.waits_for != 0) {
    const auto other = store_.section(of.waits_for);
    if (other && !has_ended(*other)) return;
    of.waits_for = 0;
  }
  const auto members = store_.members(member.job, member.member->of);
  for (const SectionRecord& other : members) {
    if (of.waits_for == 0 && !has_ended(other)) of.waits_for = other.id;
  }
  const auto last = last_look(ensemble, place, members);
  if (!last) return;
  of.looked_at = last->members;
  if (last->summary.ending == solver::Ending::half_width) of.ended_at = last->members;
}

}  // namespace leda::server
