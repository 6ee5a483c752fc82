#pragma once
// What an ensemble says of one section: as JSON, its members as CSV, and a table for people.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/documents/ensemble_case.hpp"
#include "solver/ensemble/summary.hpp"

namespace leda::server {

/// Stands in every document, file and drawing of an ensemble.
inline constexpr const char* ensemble_condition =
    "conditional on a slide starting at the section: no yearly probability and no class of a "
    "regulation";

struct SectionEnsemble {
  std::string section;
  EnsembleRequest asked;
  solver::EnsembleSummary summary;
};

/// Format: README.md of this folder, "The ensemble".
nlohmann::json to_document(const SectionEnsemble& ensemble);

/// Quantiles of several sections beside each other, and each section's against the first, later
/// minus first: null where one of the two is a lower bound or not known. The curves of all.
nlohmann::json compare_ensembles(const std::vector<SectionEnsemble>& ensembles);

/// One run of a section's ensemble, for members.csv.
struct MemberRow {
  std::string section;
  MemberRun run;
  double weight = 0;           ///< in the section's numbers; 0 of other seeds and finer cells
  std::vector<double> inputs;  ///< as drawn
  std::uint64_t seed = 0;      ///< of the particles
  double cell_m = 0;
  std::optional<SectionResult> result;
  bool screened_stable = false;  ///< not simulated: its distances are 0
};

/// The row of a run at a place of the ensemble, with a weight of 0.
MemberRow row_of(const Ensemble& ensemble, const solver::Place& place, const MemberRun& run,
                 std::optional<SectionResult> result);

/// Each of the first members counts the same, and nothing else does.
void weigh(std::vector<MemberRow>& rows, std::size_t members);

/// The members of a section with their repeats and finer pairs, by number.
/// @pre the rows hold every member up to the last one
std::vector<solver::Member> members_of(const std::vector<MemberRow>& rows);

/// One line a run; "kind" is member, seed or finer. Columns of inputs have their names.
std::string members_csv_head(const std::vector<solver::UncertainInput>& inputs);
std::string members_csv_line(const MemberRow& row);

/// "120.0", ">187.0" for a lower bound, "-" where it is not known.
std::string distance_text(const solver::ExceedanceQuantile& quantile);

/// Lines for a terminal.
std::string ensemble_table(const SectionEnsemble& ensemble);

/// A line a section for a terminal: how probable it is that it slides, and the retrogression that
/// is exceeded with each probability. Empty without sections.
std::string quantile_table(const std::vector<SectionEnsemble>& ensembles);

}  // namespace leda::server
