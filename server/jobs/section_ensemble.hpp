#pragma once
// The ensemble of a section as a job: its members are the job's sections, run, tried again,
// cancelled and adopted like any other.

#include <memory>
#include <optional>
#include <vector>

#include "server/documents/ensemble_document.hpp"
#include "server/jobs/process.hpp"

namespace leda::server {

/// Members wait in their order. When all of a look (64, 128, ... members) have ended and it is sure
/// enough, those that wait are not run. No core waits for a look: those that were free before have
/// begun members of the next one, on a wide cluster all of them.
std::unique_ptr<Work> open_section_ensemble(EnsembleCase ensemble, const db::Store& store);

struct EnsembleOfJob {
  std::vector<solver::UncertainInput> inputs;
  std::vector<MemberRow> rows;              ///< one a section of the job that was run
  std::optional<SectionEnsemble> ensemble;  ///< absent: its first look is not over
};

/// What a job says by now.
/// @throws Problem no_such_result where the job has no ensemble
EnsembleOfJob ensemble_of(const db::JobRecord& job, const std::vector<db::SectionRecord>& sections);

}  // namespace leda::server
