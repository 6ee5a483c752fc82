#pragma once
// The runs of an ensemble as rows: for what they say together, and as CSV.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "server/documents/ensemble_case.hpp"
#include "solver/ensemble/summary.hpp"

namespace leda::server {

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

}  // namespace leda::server
