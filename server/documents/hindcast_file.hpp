#pragma once
// The request for a hindcast: past slides with what was observed, and which numbers are uncertain.
// As a file for `leda hindcast` and as the inputs of the process hindcast. Published schema:
// schema/hindcast-request.json; format: README.md of this folder, "The hindcast".

#include <string>
#include <string_view>
#include <vector>

#include "server/documents/ensemble_case.hpp"
#include "server/documents/named_case.hpp"
#include "solver/hindcast/posterior.hpp"

namespace leda::server {

inline constexpr std::size_t most_past_slides = 50;
inline constexpr std::size_t most_hindcast_runs = 20'000;

/// The case of a past slide.
struct PastCase {
  CaseFile of;  ///< with its numbers as given
  UncertainDocument document;
  std::string source;  ///< of what was observed, in the user's words; empty: not said
};

struct HindcastFile {
  std::string name;
  solver::HindcastPlan plan;
  std::vector<InputPlace> places;                   ///< one an input of the plan
  nlohmann::json inputs = nlohmann::json::array();  ///< "inputs" of the ensemble, as given
  std::vector<PastCase> cases;                      ///< one a slide of the plan

  const std::string& slide(const solver::HindcastRun& run) const;
  std::vector<double> inputs_of(const solver::SharedDraws& draws,
                                const solver::HindcastRun& run) const;
  /// A self-contained case file. Of its output the first and the last frame alone are kept.
  nlohmann::json case_of(const solver::SharedDraws& draws, const solver::HindcastRun& run) const;
};

/// "wave-1-slide-2-member-7", with "-local-2" after it where a member draws again: a name for a
/// run, and for a folder. Counted from 1 but for members.
std::string run_name(const solver::SharedPlan& plan, const solver::HindcastRun& run);

/// The runs of a wave with one draw of the local inputs, both counted from 0; they are as many for
/// each. A member is drawn again at a slide where it slid in none of its draws before.
std::vector<solver::HindcastRun> runs_of_draw(const solver::HindcastPlan& plan, std::size_t wave,
                                              std::size_t local);

/// On the command line: "case_file" may stand in place of "case". Every fault at once, those of
/// cases and of members of the first wave too.
Parsed<HindcastFile> parse_hindcast_file(std::string_view text, const CaseReader& read_case);

/// The body of the process hindcast: {"inputs": {...}}; no "case_file".
Parsed<HindcastFile> parse_hindcast_request(std::string_view text,
                                            Members members = Members::checked);

}  // namespace leda::server
