#pragma once
// What a job would be: its sections and an estimate of its cost. Nothing is stored or run.

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "db/store.hpp"
#include "server/jobs/process.hpp"

namespace leda::server {

/// Sections looked at by screening at most; the others are taken to be like them.
inline constexpr std::size_t most_screened_in_a_dry_run = 500;

/// The answer to dryRun. @param sections as planned
nlohmann::json dry_run(const Process& process, const Work& work,
                       std::vector<db::SectionRecord> sections, const db::Store& store);

/// Particles of all runs of a job together: what limits its size.
double particles_of(const Work& work, const std::vector<db::SectionRecord>& sections);

}  // namespace leda::server
