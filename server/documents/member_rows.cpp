#include "server/documents/member_rows.hpp"

#include <fmt/format.h>

#include <utility>

namespace leda::server {
namespace {

const char* kind_of_run(const MemberRun& run) {
  if (run.finer) return "finer";
  return run.repeat > 0 ? "seed" : "member";
}

solver::MemberOutcome outcome_of(const MemberRow& row) {
  if (row.result) return solver::outcome_of(*row.result);
  if (row.screened_stable) return solver::stands();
  return {};
}

}  // namespace

MemberRow row_of(const Ensemble& ensemble, const solver::Place& place, const MemberRun& run,
                 std::optional<SectionResult> result) {
  const Resolution resolution = ensemble.resolution_of(place, run);
  MemberRow row;
  row.section = place.section;
  row.run = run;
  row.inputs = ensemble.inputs_of(place, run.member);
  row.seed = resolution.seed;
  row.cell_m = resolution.cell_m;
  row.result = std::move(result);
  return row;
}

void weigh(std::vector<MemberRow>& rows, std::size_t members) {
  for (MemberRow& row : rows) {
    const bool counts = row.run == MemberRun{row.run.member} && row.run.member < members;
    row.weight = counts ? 1 / static_cast<double>(members) : 0;
  }
}

std::vector<solver::Member> members_of(const std::vector<MemberRow>& rows) {
  std::vector<solver::Member> members;
  for (const MemberRow& row : rows) {
    if (members.size() <= row.run.member) members.resize(row.run.member + 1);
    solver::Member& member = members[row.run.member];
    auto outcome = outcome_of(row);
    if (row.run.finer) {
      member.finer = std::move(outcome);
    } else if (row.run.repeat > 0) {
      member.repeats.push_back(std::move(outcome));
    } else {
      member.inputs = row.inputs;
      member.outcome = std::move(outcome);
    }
  }
  return members;
}

std::string members_csv_head(const std::vector<solver::UncertainInput>& inputs) {
  std::string text = "section,member,kind,weight";
  for (const auto& input : inputs) text += "," + input.name;
  return text +
         ",seed,cell_m,status,retrogression_m,retrogression_is,runout_m,runout_is,run_time_s,"
         "case_sha256,version\r\n";
}

std::string members_csv_line(const MemberRow& row) {
  std::string text =
      fmt::format("\"{}\",{},{},{}", row.section, row.run.member, kind_of_run(row.run), row.weight);
  for (const double input : row.inputs) text += fmt::format(",{}", input);
  text += fmt::format(",{},{},", row.seed, row.cell_m);
  if (!row.result) {
    return text +
           (row.screened_stable ? "stable,0,measured,0,measured,0,,\r\n" : "no-result,,,,,,,\r\n");
  }
  const SectionResult& r = *row.result;
  return text + fmt::format("{},{},{},{},{},{},{},{}\r\n", to_string(r.status),
                            r.crest_to_crest_retrogression_m, to_string(r.retrogression_is),
                            r.runout_m, to_string(r.runout_is), r.run_time_s, r.case_sha256,
                            r.version);
}

}  // namespace leda::server
