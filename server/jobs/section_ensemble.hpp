#pragma once
// The ensemble of a case as a job: one section, run as it was given, and its members.

#include <memory>

#include "server/documents/ensemble_case.hpp"
#include "server/jobs/process.hpp"

namespace leda::server {

/// Members wait in their order. When all of a look (64, 128, ... members) have ended and it is sure
/// enough, those that wait are not run. No core waits for a look: those that were free before have
/// begun members of the next one, on a wide cluster all of them.
std::unique_ptr<Work> open_section_ensemble(EnsembleCase ensemble, const db::Store& store);

}  // namespace leda::server
