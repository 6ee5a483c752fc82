#include "server/jobs/section_ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "server/documents/simulate_request.hpp"
#include "server/jobs/without_map.hpp"
#include "server/operate/problem.hpp"
#include "solver/section/warnings.hpp"

namespace leda::server {
namespace {

using db::SectionRecord;
using db::SectionState;

bool has_ended(const SectionRecord& section) {
  return section.state != SectionState::waiting && section.state != SectionState::running;
}

/// The rows of the first members with their repeats and finer pairs.
/// @return nothing where one of them has not ended
std::optional<std::vector<MemberRow>> look(const EnsembleCase& ensemble,
                                           const std::vector<SectionRecord>& sections,
                                           std::size_t members) {
  const auto runs = member_runs(ensemble.asked.plan, 0, members);
  std::vector<MemberRow> rows;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const SectionRecord& section = sections.at(i);
    if (!has_ended(section)) return std::nullopt;
    rows.push_back(row_of(ensemble, runs[i], section.result));
  }
  return rows;
}

struct Look {
  std::size_t members = 0;
  solver::EnsembleSummary summary;
};

/// The look that ended the ensemble, else the last one that is over; nothing before the first.
std::optional<Look> last_look(const EnsembleCase& ensemble,
                              const std::vector<SectionRecord>& sections) {
  const auto& plan = ensemble.asked.plan;
  std::optional<Look> last;
  for (std::size_t n = plan.stop.min_members; n <= plan.stop.max_members; n *= 2) {
    const auto rows = look(ensemble, sections, n);
    if (!rows) break;
    last = Look{n, solver::summarize(plan, members_of(*rows))};
    if (last->summary.ending != solver::Ending::more_members) break;
  }
  return last;
}

class SectionEnsembleJob final : public WithoutMap {
 public:
  SectionEnsembleJob(EnsembleCase ensemble, const db::Store& store)
      : ensemble_(std::move(ensemble)),
        store_(store),
        runs_(member_runs(ensemble_.asked.plan, 0, ensemble_.asked.plan.stop.max_members)) {}

  std::vector<SectionRecord> plan() const override {
    std::vector<SectionRecord> sections;
    auto record = record_of(ensemble_.of.section);
    record.warnings = warnings_of(ensemble_.of.section, ensemble_.of.settings);
    for (const MemberRun& run : runs_) {
      record.ordinal = static_cast<int>(sections.size());
      record.name = run_name(run);
      sections.push_back(record);
    }
    return sections;
  }

  std::string case_file(const SectionRecord& section) const override {
    return ensemble_.case_of(run_of(section)).dump(2) + "\n";
  }

  RunSize size(const SectionRecord& section) const override {
    RunSettings settings = ensemble_.of.settings;
    settings.resolution = ensemble_.resolution_of(run_of(section));
    settings.output = Output{};
    return run_size(ensemble_.of.section, settings);
  }

  bool keeps_fields() const override { return false; }

  bool may_be_spared(const SectionRecord& section) const override {
    return run_of(section).member >= ensemble_.asked.plan.stop.min_members;
  }

  std::string not_needed(const SectionRecord& section) const override {
    const std::size_t member = run_of(section).member;
    if (!ended_at_ && look_before(member) > looked_at_) look_again(section.job);
    if (!ended_at_ || member < *ended_at_) return "";
    return fmt::format("not needed: {} members are sure enough", *ended_at_);
  }

 private:
  const MemberRun& run_of(const SectionRecord& section) const {
    return runs_.at(static_cast<std::size_t>(section.ordinal));
  }

  /// The largest look that a member is not part of; 0: it is part of the first.
  std::size_t look_before(std::size_t member) const {
    std::size_t look = 0;
    for (std::size_t n = ensemble_.asked.plan.stop.min_members; n <= member; n *= 2) look = n;
    return look;
  }

  void look_again(const std::string& job) const {
    const auto last = last_look(ensemble_, store_.sections(job));
    if (!last) return;
    looked_at_ = last->members;
    if (last->summary.ending == solver::Ending::half_width) ended_at_ = last->members;
  }

  EnsembleCase ensemble_;
  const db::Store& store_;
  std::vector<MemberRun> runs_;  ///< by ordinal of the section
  // Of the dispatcher's thread alone:
  mutable std::size_t looked_at_ = 0;            ///< members of the last look
  mutable std::optional<std::size_t> ended_at_;  ///< and of the one that was sure enough
};

}  // namespace

std::unique_ptr<Work> open_section_ensemble(EnsembleCase ensemble, const db::Store& store) {
  return std::make_unique<SectionEnsembleJob>(std::move(ensemble), store);
}

EnsembleOfJob ensemble_of(const db::JobRecord& job, const std::vector<SectionRecord>& sections) {
  const auto request = job.process == "simulate-section"
                           ? parse_simulate_request(job.request, Members::taken)
                           : Parsed<SimulateRequest>{};
  if (!request || !request.value->ensemble) {
    throw Problem(Failure::no_such_result, "job " + job.id + " has no ensemble");
  }
  const EnsembleCase& ensemble = *request.value->ensemble;
  const auto& plan = ensemble.asked.plan;
  const auto runs = member_runs(plan, 0, plan.stop.max_members);
  EnsembleOfJob out;
  out.inputs = plan.inputs;
  for (const SectionRecord& section : sections) {
    if (!has_ended(section) || section.state == SectionState::left_out) continue;
    out.rows.push_back(
        row_of(ensemble, runs.at(static_cast<std::size_t>(section.ordinal)), section.result));
  }
  if (auto last = last_look(ensemble, sections)) {
    weigh(out.rows, last->members);
    out.ensemble = SectionEnsemble{ensemble.of.section.name, ensemble.asked, last->summary};
  }
  return out;
}

}  // namespace leda::server
