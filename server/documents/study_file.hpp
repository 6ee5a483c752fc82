#pragma once
// The request for a study: one case, and the settings to run it at. As a file for `leda study`
// and as the inputs of the process resolution-study. Published schema:
// schema/resolution-study-request.json; format: README.md of this folder.

#include <string>
#include <string_view>

#include "server/documents/named_case.hpp"
#include "solver/study/study.hpp"

namespace leda::server {

inline constexpr std::size_t most_study_runs = 1000;

struct StudyFile {
  std::string name;
  CaseFile of;  ///< as given; a setting takes the place of its resolution and time step
  solver::StudyQuestion question;
  int workers = 1;      ///< runs at the same time; 0: one a core
  std::string machine;  ///< where it runs, in the user's words; empty: not said
};

/// A study on the command line: "case_file" may stand in place of "case", and "workers" is known.
/// Every fault at once, those of the case too.
Parsed<StudyFile> parse_study_file(std::string_view text, const CaseReader& read_case);

/// The body of resolution-study: {"inputs": {...}}; neither "case_file" nor "workers".
Parsed<StudyFile> parse_study_request(std::string_view text);

/// Whether names of its settings tell the time step: some setting takes another than the case's
/// own.
bool tells_time_step(const StudyFile& study);

}  // namespace leda::server
