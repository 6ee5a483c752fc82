#pragma once
// What a study says: study.json, study.csv, and a table for people.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "server/documents/study_file.hpp"
#include "solver/study/study.hpp"

namespace leda::server {

struct Study {
  StudyFile asked;
  std::vector<solver::StudyRun> runs;
  solver::StudySummary summary;
  std::string date;  ///< UTC, ISO 8601: when the last of it was computed
};

/// Draws the conclusions from runs that are over.
Study conclude(StudyFile asked, std::vector<solver::StudyRun> runs, std::string date);

/// Format: README.md of this folder, "The study". Run times are wall times as measured.
nlohmann::json to_document(const Study& study);

/// One line a run, units in the names of the columns; texts in quotes (RFC 4180).
std::string study_csv(const Study& study);

/// One line a setting, one an axis, then what it comes to, a sentence a line.
std::string study_table(const Study& study);

/// What it comes to: the fastest setting within the wanted error by both distances and by each of
/// them, the floor, and how far the answer depends on each axis and on the seed.
std::vector<std::string> study_outcome(const Study& study);

/// What its runs are warned of, each text with the settings it is about. A run without a result is
/// warned of what is known before it: that is all where no run has been made.
std::vector<std::string> study_warnings(const StudyFile& asked,
                                        const std::vector<solver::StudyRun>& runs);

/// "1.5 m, 4 particles"; with its time step where the study asks for another than the case's own
std::string setting_name(const Study& study, const solver::StudySetting& setting);

}  // namespace leda::server
