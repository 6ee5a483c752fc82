#pragma once
// The rows of the store as plain values. Times are UTC, ISO 8601 with Z.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "profiles/map/coordinates.hpp"
#include "profiles/map/placed_result.hpp"
#include "profiles/map/profile.hpp"
#include "profiles/map/zone.hpp"
#include "solver/section/section_result.hpp"

namespace leda::db {

struct RasterRecord {
  std::string id;    ///< "dem-" and the first 12 hex digits of the sha256
  std::string name;  ///< chosen by the user, unique
  std::string file;  ///< relative to the data folder
  std::string sha256;
  int epsg = 0;
  double cell_x = 0, cell_y = 0;  ///< units of the CRS
  int width = 0, height = 0;      ///< cells
  MapBox box{};
  std::string vertical_unit;  ///< "m" or "ft" or "us-ft"
  std::string created;
  // What registration found in the cells; absent in rows of before.
  std::optional<double> lowest_m{}, highest_m{};
  std::optional<double> share_without_data{};
  std::optional<double> cell_ground_x_m{}, cell_ground_y_m{};  ///< at the DEM's middle
  std::optional<double> undeclared_fill_m{};  ///< cells of this value count as missing
  std::vector<std::string> warnings{};
  std::string removed{};  ///< when its file went; empty: it stands
};

enum class JobState { accepted, running, successful, failed, dismissed };

const char* to_string(JobState state);
std::optional<JobState> job_state_from(const std::string& text);
constexpr bool is_final(JobState state) {
  return state != JobState::accepted && state != JobState::running;
}

/// A job but for its request.
struct JobStatus {
  std::string id;
  std::string process;  ///< "map-region", "simulate-section", ...
  std::string name;
  JobState state = JobState::accepted;
  std::string message;
  int progress = 0;             ///< 0 to 100
  std::string idempotency_key;  ///< empty: none
  std::string created, started, finished, updated;
  std::string raster;         ///< id of the DEM it stands on; empty: none
  std::int64_t sequence = 0;  ///< given by the store: the order in which jobs were accepted
};

struct JobRecord : JobStatus {
  std::string request;  ///< the execute request as sent, JSON: up to 16 MiB
};

enum class SectionState {
  waiting,  ///< to be simulated
  running,
  finished,  ///< a result stands
  left_out,  ///< could not be cut: reason
  stable,    ///< screened: not simulated
  failed,    ///< ran and gave no usable result: reason
  dismissed
};

const char* to_string(SectionState state);
std::optional<SectionState> section_state_from(const std::string& text);

/// Which run of an ensemble a row stands for.
struct MemberRecord {
  int of = 0;           ///< ordinal of the section it is a member of
  std::string section;  ///< its name
  int number = 0;       ///< of the draw
  int repeat = 0;       ///< the same draw with another seed; 0: the member itself
  bool finer = false;   ///< the same draw with finer cells
};

/// A section of a job, or a member of one: that is given the ground of its section.
struct SectionRecord {
  std::int64_t id = 0;  ///< given by the store
  std::string job;
  int ordinal = 0;  ///< order within the job
  std::string name;
  int line = -1;     ///< sections along the same line are neighbours; named lines: -1
  double order = 0;  ///< position along the line, m
  MapLine trace;
  Polyline ground;  ///< empty where left out
  Point crest, toe;
  SectionState state = SectionState::waiting;
  std::string reason;
  std::string screening;  ///< JSON; empty: not screened
  std::vector<std::string> warnings;
  std::string run;  ///< id of the latest run, also its folder under runs/
  int attempts = 0;
  std::optional<SectionResult> result;
  std::optional<PlacedResult> placed;
  std::optional<MemberRecord> member = std::nullopt;  ///< absent: a section
};

/// As much of a section as says whether it waits.
struct SectionInLine {
  std::int64_t id = 0;
  SectionState state = SectionState::waiting;
  bool is_member = false;
};

/// One try at a section. Every try is kept.
struct RunRecord {
  std::string id;  ///< also its folder under runs/
  std::int64_t section = 0;
  int attempt = 0;  ///< 1, 2, ...
  std::string started, finished;
  /// "result", "unstable", "failed", "interrupted", "dismissed", "superseded" (another run's
  /// result came first); empty: under way
  std::string outcome;
  std::string reason;
};

struct ZoneRecord {
  std::int64_t id = 0;
  std::string job;
  Zone zone;
  std::string version;  ///< of Leda, that its sections were computed with; several: with commas
};

/// A section or a zone on the map: {west, south, east, north}, degrees.
struct FeatureBox {
  std::int64_t id = 0;
  MapBox box{};
};

/// What a run took, at the median of many.
struct TypicalRun {
  int runs = 0;  ///< it is taken from
  double simulated_s = 0;
  double ns_per_particle_step = 0;
  double steps_per_simulated_s = 0;
};

}  // namespace leda::db
