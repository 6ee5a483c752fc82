#pragma once
// What an ensemble says of one section: as JSON, and as a table for people.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/documents/member_rows.hpp"
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
  std::vector<std::string> warnings{};         ///< of the base case
  std::vector<std::string> member_warnings{};  ///< what members are warned of beyond it, as lines
};

/// Format: README.md of this folder, "The ensemble".
nlohmann::json to_document(const SectionEnsemble& ensemble);

/// Quantiles of several sections beside each other, and each section's against the first, later
/// minus first: null where one of the two is a lower bound or not known. The curves of all.
nlohmann::json compare_ensembles(const std::vector<SectionEnsemble>& ensembles);

/// "120.0", ">187.0" for a lower bound, "-" where it is not known.
std::string distance_text(const solver::ExceedanceQuantile& quantile);

/// Lines for a terminal.
std::string ensemble_table(const SectionEnsemble& ensemble);

/// A line a section for a terminal: how probable it is that it slides, and the retrogression that
/// is exceeded with each probability; below them what members are warned of. Empty without
/// sections.
std::string quantile_table(const std::vector<SectionEnsemble>& ensembles);

}  // namespace leda::server
