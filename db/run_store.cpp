// Runs: every try at a section.

#include "db/connection.hpp"
#include "db/section_row.hpp"
#include "db/store.hpp"

namespace leda::db {

void close_run(Database& database, std::int64_t section, const char* outcome,
               const std::string& reason) {
  Query(database,
        "UPDATE runs SET finished = ?2, outcome = ?3, reason = ?4 "
        "WHERE section_id = ?1 AND outcome IS NULL")
      .with(section, utc_now(), outcome, reason)
      .run();
}

bool Store::start_run(std::int64_t section, const std::string& run) {
  return connection_->write([&](Database& database) {
    const SectionState state = state_of_section(database, section);
    if (state == SectionState::finished || state == SectionState::dismissed) return false;
    close_run(database, section, "interrupted", "another try was started");
    Query(database,
          "INSERT INTO runs (id, section_id, attempt, started, reason) VALUES (?1, ?2, "
          "(SELECT count(*) + 1 FROM runs WHERE section_id = ?2), ?3, '')")
        .with(run, section, utc_now())
        .run();
    Query(database,
          "UPDATE sections SET state = 'running', reason = '', latest_run_id = ?2 WHERE id = ?1")
        .with(section, run)
        .run();
    return true;
  });
}

std::vector<RunRecord> Store::runs(std::int64_t section) const {
  return connection_->read([&](Database& database) {
    std::vector<RunRecord> all;
    Query rows(database,
               "SELECT id, section_id, attempt, started, finished, outcome, reason FROM runs "
               "WHERE section_id = ? ORDER BY attempt");
    rows.with(section);
    while (rows.next())
      all.push_back(RunRecord{.id = rows.text(),
                              .section = rows.integer(),
                              .attempt = rows.small_integer(),
                              .started = rows.text(),
                              .finished = rows.text(),
                              .outcome = rows.text(),
                              .reason = rows.text()});
    return all;
  });
}

}  // namespace leda::db
