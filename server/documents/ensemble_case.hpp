#pragma once
// A case some of whose numbers are uncertain: a case file with an "ensemble" beside its members.

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "server/documents/case_file.hpp"
#include "server/documents/uncertain_document.hpp"
#include "solver/ensemble/draws.hpp"

namespace leda::server {

/// One run of an ensemble: a member, the same with another seed, or the same with finer cells.
struct MemberRun {
  std::size_t member = 0;
  std::size_t repeat = 0;  ///< 0: the member itself
  bool finer = false;

  bool operator==(const MemberRun&) const = default;
};

/// "member-7", "member-7-seed-2", "member-7-finer": a name for a run, and for a folder.
std::string run_name(const MemberRun& run);

/// What the members and the check of an ensemble run, from a member on, before another one.
std::vector<MemberRun> member_runs(const solver::EnsemblePlan& plan, std::size_t from,
                                   std::size_t before);

struct EnsembleCase {
  CaseFile of;  ///< with its numbers as given
  EnsembleRequest asked;
  UncertainDocument document;
  solver::Draws draws;

  solver::Place place() const { return {"", of.section.name}; }
  std::vector<double> inputs_of(std::size_t member) const;
  /// Resolution of a run: its seed, and its cell where it is a finer one.
  Resolution resolution_of(const MemberRun& run) const;
  /// A self-contained case file. Of its output the first and the last frame alone are kept.
  nlohmann::json case_of(const MemberRun& run) const;
};

/// Whether each member is read as a case, which takes half a millisecond, or was before.
enum class Members { checked, taken };

/// Every fault at once, those of the case and of each member that could not be run too.
Parsed<EnsembleCase> parse_ensemble_case(std::string_view text);

/// The same for a case and its ensemble inside other documents.
Parsed<EnsembleCase> read_ensemble_case(const nlohmann::json& document, const std::string& case_at,
                                        const nlohmann::json& ensemble,
                                        const std::string& ensemble_at,
                                        Members members = Members::checked);

}  // namespace leda::server
