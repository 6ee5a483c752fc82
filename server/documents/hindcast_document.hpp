#pragma once
// What past slides teach: as JSON, its runs as CSV, and a table for people.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/documents/hindcast_file.hpp"
#include "solver/hindcast/hindcast.hpp"
#include "solver/section/section_result.hpp"

namespace leda::server {

/// Stands in every document, file and drawing of a hindcast.
inline constexpr const char* hindcast_condition =
    "conditional on slides that happened: it says nothing of how probable a slide is";

/// One run, for members.csv.
struct HindcastRow {
  solver::HindcastRun run;
  std::vector<double> inputs;  ///< as drawn
  std::uint64_t seed = 0;      ///< of the particles
  std::optional<SectionResult> result;
};

struct Hindcast {
  const HindcastFile& asked;
  const solver::SharedDraws& draws;
  const std::vector<HindcastRow>& rows;
  solver::HindcastSummary summary;
};

/// Whether a run is to be made: its member slid there in none of the rows, which hold all its draws
/// before.
std::vector<solver::HindcastRun> still_wanted(const std::vector<solver::HindcastRun>& runs,
                                              const std::vector<HindcastRow>& rows);

HindcastRow row_of(const HindcastFile& file, const solver::SharedDraws& draws,
                   const solver::HindcastRun& run, std::optional<SectionResult> result);

/// What the runs of all waves drawn say. @param rows in the order of their draws
solver::SlideOutcomes outcomes_of(const HindcastFile& file, const solver::SharedDraws& draws,
                                  const std::vector<HindcastRow>& rows);

/// Format: README.md of this folder, "The hindcast".
nlohmann::json to_document(const Hindcast& hindcast);

/// The shared inputs after the slides were seen, as "inputs" of an ensemble: columns of one
/// "sample". Empty where no member has a weight.
nlohmann::json posterior_inputs(const Hindcast& hindcast);

/// "Leda after 4 past slides (...)": how few slides stand behind it.
std::string posterior_label(const Hindcast& hindcast);

/// One line a run. Weights are those of the member.
std::string members_csv(const Hindcast& hindcast);

/// "64.0 to 210.5", "64.0 and more" where members that were cut short know no upper end.
std::string interval_text(const solver::Prediction& prediction);

/// "100", "at least 40", "40 to 60".
std::string observed_text(const solver::Observed& observed);

/// Lines for a terminal.
std::string hindcast_table(const Hindcast& hindcast);

}  // namespace leda::server
