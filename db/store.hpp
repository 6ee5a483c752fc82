#pragma once
// The store: one SQLite file, one writer. Every member is one transaction: it happens whole or
// not at all. Safe to call from several threads. Throws StoreError when SQLite fails.

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "db/records.hpp"

namespace leda::db {

class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct JobFilter {
  std::vector<std::string> processes;  ///< empty: any
  std::vector<JobState> states;        ///< empty: any
  std::string created_from, created_to;  ///< ISO 8601, empty: open
  int limit = 100;
  int offset = 0;
};

class Store {
 public:
  /// Opens or makes the file, brings it to the newest schema (numbered migrations, WAL).
  explicit Store(const std::filesystem::path& file);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // Rasters
  void add_raster(const RasterRecord& raster);  ///< replaces a raster of the same id
  std::vector<RasterRecord> rasters() const;
  std::optional<RasterRecord> raster(const std::string& id_or_name) const;

  // Jobs
  void add_job(const JobRecord& job);
  std::optional<JobRecord> job(const std::string& id) const;
  std::optional<JobRecord> job_by_idempotency_key(const std::string& key) const;
  std::vector<JobRecord> jobs(const JobFilter& filter) const;
  int count_jobs(const JobFilter& filter) const;
  std::vector<JobRecord> unfinished_jobs() const;  ///< accepted or running, oldest first
  void set_job_state(const std::string& id, JobState state, const std::string& message);
  void set_job_progress(const std::string& id, int progress, const std::string& message);

  // Sections of a job
  /// Stores the whole layout of a job, replacing what an interrupted earlier try left.
  void set_sections(const std::string& job, const std::vector<SectionRecord>& sections);
  std::vector<SectionRecord> sections(const std::string& job) const;  ///< by ordinal
  std::optional<SectionRecord> section(const std::string& job, const std::string& name) const;
  /// Counts a try and remembers its run folder; state becomes running.
  void start_run(std::int64_t section, const std::string& run);
  void set_section_state(std::int64_t section, SectionState state, const std::string& reason);
  /// Puts back to waiting what was running (the server was killed) and returns how many.
  int requeue_running(const std::string& job);
  /// One result a section: taking the same run in again changes nothing (returns false).
  bool take_in(std::int64_t section, const std::string& run, const SectionResult& result,
               const PlacedResult& placed, const std::string& result_json);

  // Zones of a job
  void set_zones(const std::string& job, const std::vector<Zone>& zones);
  std::vector<ZoneRecord> zones(const std::string& job) const;

 private:
  class Connection;
  std::unique_ptr<Connection> connection_;
};

/// Now, UTC, "2026-01-31T12:00:00.000Z".
std::string utc_now();

}  // namespace leda::db
