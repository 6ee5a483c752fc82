#pragma once
// What a run will cost, before it is started.

#include <cstddef>
#include <optional>

#include "db/records.hpp"
#include "solver/section/run_settings.hpp"
#include "solver/section/section.hpp"

namespace leda::server {

struct RunSize {
  double particles = 0;
  double steps_per_simulated_s = 0;  ///< on ground at rest; fast ground takes more
  double longest_s = 0;              ///< simulated time it may take
  double frames = 2;                 ///< kept in fields.h5
  double ns_per_particle_step = 0;   ///< where the store holds no results yet
};

/// From the ground's area, the cell, and the wave speed of the stiffest material.
/// @pre the section has no faults
RunSize run_size(const Section& section, const RunSettings& settings);

/// What runs have taken so far; where there were none, how long runs move, the rest being zero.
db::TypicalRun typical_or_default(const std::optional<db::TypicalRun>& measured);

struct RunCost {
  double likely_core_s = 0;   ///< it comes to rest as others did
  double longest_core_s = 0;  ///< it moves to the end of its time
  double disk_bytes = 0;      ///< of the whole run folder, checkpoint included
};

RunCost cost_of(const RunSize& size, const db::TypicalRun& typical);

}  // namespace leda::server
