// What is kept, what may go, and copies of the store.

#include <SQLiteCpp/Backup.h>

#include "db/connection.hpp"
#include "db/store.hpp"
#include "disk/new_file.hpp"

namespace leda::db {

namespace {

std::vector<std::string> texts(Query& rows) {
  std::vector<std::string> all;
  while (rows.next()) all.push_back(rows.text());
  return all;
}

void require_sound(SQLite::Database& copy, const std::filesystem::path& file) {
  SQLite::Statement check(copy, "PRAGMA integrity_check");
  if (!check.executeStep() || check.getColumn(0).getString() != "ok")
    throw StoreError(file.string() + ": the copy of the store is damaged");
}

}  // namespace

std::vector<std::string> Store::jobs_finished_before(const std::string& time) const {
  return connection_->read([&](Database& database) {
    Query rows(database,
               "SELECT id FROM jobs WHERE state IN ('successful', 'failed', 'dismissed') "
               "AND finished <= ? ORDER BY sequence");
    rows.with(time);
    return texts(rows);
  });
}

bool Store::remove_job(const std::string& id) {
  return connection_->write([&](Database& database) {
    return Query(database, "DELETE FROM jobs WHERE id = ? AND state NOT IN ('accepted', 'running')")
               .with(id)
               .run() > 0;
  });
}

std::vector<std::string> Store::run_folders(const std::string& job) const {
  return connection_->read([&](Database& database) {
    Query rows(database,
               "SELECT runs.id FROM runs JOIN sections ON sections.id = runs.section_id "
               "WHERE sections.job_id = ? ORDER BY runs.section_id, runs.attempt");
    rows.with(job);
    return texts(rows);
  });
}

bool Store::has_run(const std::string& run) const {
  return connection_->read([&](Database& database) {
    Query row(database, "SELECT 1 FROM runs WHERE id = ?");
    return row.with(run).next();
  });
}

std::vector<std::string> Store::latest_runs() const {
  return connection_->read([&](Database& database) {
    Query rows(database,
               "SELECT latest_run_id FROM sections WHERE latest_run_id IS NOT NULL ORDER BY id");
    return texts(rows);
  });
}

// Median of what the newest runs took: the machine and the version change over the years.
std::optional<TypicalRun> Store::typical_run() const {
  return connection_->read([&](Database& database) -> std::optional<TypicalRun> {
    const auto median = [&](const std::string& value) {
      Query row(database,
                "WITH newest AS (SELECT " + value +
                    " AS value FROM results WHERE steps > 0 AND simulated_s > 0 "
                    "AND ns_per_particle_step > 0 ORDER BY rowid DESC LIMIT 1000) "
                    "SELECT value, (SELECT count(*) FROM newest) FROM newest ORDER BY value "
                    "LIMIT 1 OFFSET (SELECT count(*) FROM newest) / 2");
      if (!row.next()) return std::pair{0.0, 0};
      const double found = row.real();
      return std::pair{found, row.small_integer()};
    };
    const auto [simulated_s, runs] = median("simulated_s");
    if (runs == 0) return std::nullopt;
    return TypicalRun{.runs = runs,
                      .simulated_s = simulated_s,
                      .ns_per_particle_step = median("ns_per_particle_step").first,
                      .steps_per_simulated_s = median("steps / simulated_s").first};
  });
}

void back_up(const std::filesystem::path& store, const std::filesystem::path& copy) {
  disk::NewFile file(copy);
  try {
    std::filesystem::remove(file.part());
    SQLite::Database from(store.string(), SQLite::OPEN_READONLY, 10'000);
    {
      SQLite::Database to(file.part().string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      // All pages in one step: one read transaction, so one moment, while writers go on (WAL).
      SQLite::Backup backup(to, from);
      backup.executeStep(-1);
      require_sound(to, copy);
    }
    file.keep();
  } catch (const SQLite::Exception& error) {
    throw StoreError(store.string() + ": the store cannot be copied: " + error.what());
  }
}

}  // namespace leda::db
