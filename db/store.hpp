#pragma once
// The store: one SQLite file, one writer. Every member is one transaction: it happens whole or
// not at all. Safe to call from several threads. Throws StoreError when SQLite fails.

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "db/records.hpp"
#include "db/utc_now.hpp"

namespace leda::db {

class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A name, id or idempotency key that stands already.
class StoreConflict : public StoreError {
 public:
  using StoreError::StoreError;
};

struct JobFilter {
  std::vector<std::string> processes{};      ///< empty: any
  std::vector<JobState> states{};            ///< empty: any
  std::string created_from{}, created_to{};  ///< ISO 8601, empty: open
  int limit = 100;
  std::int64_t before = 0;  ///< only jobs accepted before the one of this `sequence`; 0: all
  std::optional<double> least_s{}, most_s{};  ///< time since it was started, until it finished
};

/// A page of sections or zones, in the order of their ids: of one job, or over all jobs that
/// succeeded and have a map.
struct PageFilter {
  std::string job{};                 ///< empty: all jobs that succeeded and have a map
  std::optional<MapBox> box{};       ///< longitude and latitude; west > east crosses 180 degrees
  std::optional<std::int64_t> id{};  ///< this one alone
  int limit = 100;
  std::int64_t after = 0;  ///< only those with an id beyond; 0: all
};

/// What the features of a layer cover together, in longitude and latitude.
struct Coverage {
  int features = 0;
  std::optional<MapBox> box;
  std::vector<int> epsg;  ///< of the DEMs they stand on
};

class Store {
 public:
  /// Opens or makes the file, brings it to the newest schema (numbered migrations, WAL).
  /// @param busy_timeout how long to wait for another program that is writing to the file
  explicit Store(const std::filesystem::path& file,
                 std::chrono::milliseconds busy_timeout = std::chrono::seconds(10));
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // Rasters
  /// Replaces a raster of the same id; StoreConflict where another one has the name.
  void add_raster(const RasterRecord& raster);
  std::vector<RasterRecord> rasters() const;  ///< without those removed
  std::optional<RasterRecord> raster(const std::string& id_or_name) const;  ///< the id wins
  /// StoreConflict where another raster has the name; false where there is no such raster.
  bool rename_raster(const std::string& id, const std::string& name);
  /// Takes a raster out of the list and frees its name. Its row stays while jobs stand on it, for
  /// the place of their features. False, and nothing changed, where an unfinished job needs it.
  bool remove_raster(const std::string& id);

  // Jobs
  /// StoreConflict where the id or the idempotency key stands already. An empty `created` or
  /// `updated` becomes now.
  void add_job(const JobRecord& job);
  std::optional<JobRecord> job(const std::string& id) const;
  std::optional<JobRecord> job_by_idempotency_key(const std::string& key) const;
  /// Without reading the request, as are the lists below.
  std::optional<JobStatus> job_status(const std::string& id) const;
  std::vector<JobStatus> jobs(const JobFilter& filter) const;  ///< newest first
  int count_jobs(const JobFilter& filter) const;
  std::vector<JobStatus> unfinished_jobs() const;  ///< accepted or running, oldest first
  /// A dismissed job stays dismissed until it is accepted again; false where that kept it.
  bool set_job_state(const std::string& id, JobState state, const std::string& message);
  /// The job is dismissed, and with it all of its sections that wait or run, with their tries.
  /// Where it had not ended it keeps no zones: they would be those of an earlier end, or of half an
  /// end.
  void dismiss_job(const std::string& id);
  /// The failed sections of a job wait again and the job is accepted; how many sections wait now.
  /// Nothing changes where that is none.
  int retry_job(const std::string& id);
  /// Only while the job is accepted or running; later it is ignored.
  void set_job_progress(const std::string& id, int progress, const std::string& message);
  /// Jobs in one of the final states that ended before a time, oldest first.
  std::vector<std::string> jobs_finished_before(const std::string& time) const;
  /// Removes a job with its sections, runs, results and zones. False where it is not finished.
  bool remove_job(const std::string& id);

  // Sections of a job
  /// Stores the whole layout of a job, once: where sections of the job stand already (the server
  /// was killed and lays it out again) they are kept, with their runs and results, and the answer
  /// is false. Of each record `id`, `run`, `attempts`, `result` and `placed` are the store's own.
  bool set_sections(const std::string& job, const std::vector<SectionRecord>& sections);
  /// Without members, by ordinal.
  std::vector<SectionRecord> sections(const std::string& job) const;
  /// Members of the section of that ordinal, by ordinal; without `ground` and the result's
  /// `profile_after`.
  std::vector<SectionRecord> members(const std::string& job, int section) const;
  /// Sections and members, by ordinal.
  std::vector<SectionInLine> sections_in_line(const std::string& job) const;
  /// Of sections and members alike.
  std::optional<SectionRecord> section(const std::string& job, const std::string& name) const;
  std::optional<SectionRecord> section(std::int64_t section) const;
  /// Counts a try and remembers its run folder; state becomes running. A try still under way is
  /// booked as interrupted. False, and nothing changed, where the section is finished or
  /// dismissed; StoreConflict where the run's id stands already.
  bool start_run(std::int64_t section, const std::string& run);
  /// Closes the try under way (back to waiting with a reason: it failed; without: it was cut off).
  /// A finished section keeps its result and its state, and a dismissed one stays dismissed: false
  /// where that kept it.
  bool set_section_state(std::int64_t section, SectionState state, const std::string& reason);
  std::vector<RunRecord> runs(std::int64_t section) const;  ///< every try, first to last
  /// Remembers what screening said of a section, JSON.
  void set_screening(std::int64_t section, const std::string& screening);
  /// One result a section: false, and nothing changed, where this run is in already, the section
  /// is finished, or it was dismissed. A result makes the section finished, an unstable one makes
  /// it failed with the result's reason (a later run may then replace it). `result_json` is kept
  /// as it is. StoreError for an interrupted result or a run of another section.
  bool take_in(std::int64_t section, const std::string& run, const SectionResult& result,
               const PlacedResult& placed, const std::string& result_json);
  /// Sections, no members, without `ground` and the result's `profile_after`.
  std::vector<SectionRecord> section_page(const PageFilter& filter) const;
  int count_sections(const PageFilter& filter) const;
  /// Sections and members in a state, of all jobs.
  int count_sections(SectionState state) const;
  /// Every run of a job's sections: the names of their folders.
  std::vector<std::string> run_folders(const std::string& job) const;
  /// Whether a run of that name was ever stored.
  bool has_run(const std::string& run) const;
  /// Runs whose folders a copy of the store needs: the latest of every section.
  std::vector<std::string> latest_runs() const;
  /// Median cost of the results in the store, for estimates; nothing where there is none.
  std::optional<TypicalRun> typical_run() const;
  /// The result_json of the section's latest run.
  std::optional<std::string> result_document(std::int64_t section) const;

  // Zones of a job
  /// Replaces the job's zones; a dismissed job gets none. StoreError where a zone names a section
  /// the job does not have.
  void set_zones(const std::string& job, const std::vector<Zone>& zones);
  std::vector<ZoneRecord> zones(const std::string& job) const;
  std::vector<ZoneRecord> zone_page(ZoneLayer layer, const PageFilter& filter) const;
  int count_zones(ZoneLayer layer, const PageFilter& filter) const;

  // Where sections and zones lie, in longitude and latitude
  /// Replaces those that stand.
  void set_section_boxes(const std::vector<FeatureBox>& boxes);
  void set_zone_boxes(const std::vector<FeatureBox>& boxes);
  /// Jobs on a DEM with a section or zone that has no box.
  std::vector<std::string> jobs_without_boxes() const;
  Coverage section_coverage() const;  ///< of all jobs that succeeded
  Coverage zone_coverage(ZoneLayer layer) const;

 private:
  class Connection;
  std::unique_ptr<Connection> connection_;
};

/// A copy of a store as it is at one moment, also while a server writes to it. The copy appears
/// whole or not at all. Throws StoreError where the store can't be read or the copy is damaged.
void back_up(const std::filesystem::path& store, const std::filesystem::path& copy);

}  // namespace leda::db
