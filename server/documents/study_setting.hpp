#pragma once
// A setting of a study in documents: members, names, and the case it turns a case into.

#include <nlohmann/json.hpp>
#include <string>

#include "server/documents/case_file.hpp"
#include "solver/study/study.hpp"

namespace leda::server {

/// The setting that the case itself asks for.
solver::StudySetting own_setting(const CaseFile& of);

/// One run of a study: the case at the run's setting and seed, first and last frame only.
CaseFile case_of(const CaseFile& of, const solver::StudyRun& run);

/// "cell-0.75-particles-4-seed-1", "cell-0.75-particles-4-step-0.9-seed-1" where the time step is
/// not the case's own: a name for a section, and for a folder.
std::string run_name(const CaseFile& of, const solver::StudyRun& run);

/// "1.5 m, 4 particles", and "1.5 m, 4 particles, step 0.9"
std::string setting_name(const solver::StudySetting& setting, bool with_step);

/// The setting's members, by axis.
nlohmann::json to_document(const solver::StudySetting& setting);

}  // namespace leda::server
