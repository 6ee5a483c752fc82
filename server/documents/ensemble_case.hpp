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

/// What was asked of members, and what is drawn for them.
struct Ensemble {
  EnsembleRequest asked;
  UncertainDocument document;  ///< that the paths of the inputs lead into
  solver::Draws draws;
  Resolution resolution;  ///< as given

  std::vector<double> inputs_of(const solver::Place& place, std::size_t member) const {
    return draws.inputs_of(place, member);
  }
  /// Resolution of a run: its seed, and its cell where it is a finer one.
  Resolution resolution_of(const solver::Place& place, const MemberRun& run) const;
};

/// An ensemble of a document, with the faults that are told once all others are mended.
/// @pre no fault was found in `asked` and `document`
Ensemble drawn(EnsembleRequest asked, UncertainDocument document, const Resolution& given,
               const std::string& at, FaultList& faults);

struct EnsembleCase : Ensemble {
  CaseFile of;  ///< with its numbers as given

  solver::Place place() const { return {"", of.section.name}; }
  std::vector<double> inputs_of(std::size_t member) const {
    return Ensemble::inputs_of(place(), member);
  }
  Resolution resolution_of(const MemberRun& run) const {
    return Ensemble::resolution_of(place(), run);
  }
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
