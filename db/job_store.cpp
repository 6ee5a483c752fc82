// Jobs: what was asked, and how far it is.

#include <utility>

#include "db/connection.hpp"
#include "db/json_text.hpp"
#include "db/store.hpp"

namespace leda::db {

namespace {

const std::string columns =
    "SELECT id, process, name, state, message, progress, idempotency_key, created, started, "
    "finished, updated, raster_id, sequence";
const std::string without_request = columns + " FROM jobs ";
const std::string with_request = columns + ", request FROM jobs JOIN requests USING (sequence) ";

// ?1 and ?2 are JSON lists, empty for any; ?3 and ?4 are times, empty for open. Times are compared
// as times: a bound may come without milliseconds. ?5 and ?6 are durations in s, negative for any.
const std::string filtered =
    "WHERE (?1 = '[]' OR process IN (SELECT value FROM json_each(?1))) "
    "AND (?2 = '[]' OR state IN (SELECT value FROM json_each(?2))) "
    "AND (?3 = '' OR julianday(created) >= julianday(?3)) "
    "AND (?4 = '' OR julianday(created) <= julianday(?4)) "
    "AND (?5 < 0 OR (julianday(coalesce(finished, 'now')) - julianday(started)) * 86400 >= ?5) "
    "AND (?6 < 0 OR (julianday(coalesce(finished, 'now')) - julianday(started)) * 86400 <= ?6) ";

JobStatus status_from(Query& row) {
  return JobStatus{.id = row.text(),
                   .process = row.text(),
                   .name = row.text(),
                   .state = job_state_from(row.text()).value(),
                   .message = row.text(),
                   .progress = row.small_integer(),
                   .idempotency_key = row.text(),
                   .created = row.text(),
                   .started = row.text(),
                   .finished = row.text(),
                   .updated = row.text(),
                   .raster = row.text(),
                   .sequence = row.integer()};
}

std::optional<std::string> null_if_empty(const std::string& text) {
  return text.empty() ? std::nullopt : std::optional(text);
}

std::string state_words(const std::vector<JobState>& states) {
  std::vector<std::string> words;
  words.reserve(states.size());
  for (const JobState state : states) words.emplace_back(to_string(state));
  return to_json(words);
}

std::optional<JobRecord> one_job(Database& database, const std::string& where,
                                 const std::string& value) {
  Query row(database, with_request + where);
  if (!row.with(value).next()) return std::nullopt;
  return JobRecord{status_from(row), row.text()};
}

}  // namespace

void Store::add_job(const JobRecord& job) {
  const std::string now = utc_now();
  connection_->write([&](Database& database) {
    Query(database,
          "INSERT INTO jobs (id, process, name, state, message, progress, idempotency_key, "
          "created, started, finished, updated, raster_id) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .with(job.id, job.process, job.name, to_string(job.state), job.message, job.progress,
              null_if_empty(job.idempotency_key), job.created.empty() ? now : job.created,
              null_if_empty(job.started), null_if_empty(job.finished),
              job.updated.empty() ? now : job.updated, null_if_empty(job.raster))
        .run();
    Query(database, "INSERT INTO requests VALUES (last_insert_rowid(), ?)").with(job.request).run();
  });
}

std::optional<JobRecord> Store::job(const std::string& id) const {
  return connection_->read(
      [&](Database& database) { return one_job(database, "WHERE id = ?", id); });
}

std::optional<JobRecord> Store::job_by_idempotency_key(const std::string& key) const {
  return connection_->read(
      [&](Database& database) { return one_job(database, "WHERE idempotency_key = ?", key); });
}

std::optional<JobStatus> Store::job_status(const std::string& id) const {
  return connection_->read([&](Database& database) -> std::optional<JobStatus> {
    Query row(database, without_request + "WHERE id = ?");
    if (!row.with(id).next()) return std::nullopt;
    return status_from(row);
  });
}

std::vector<JobStatus> Store::jobs(const JobFilter& filter) const {
  return connection_->read([&](Database& database) {
    std::vector<JobStatus> found;
    Query rows(database, without_request + filtered +
                             "AND (?8 = 0 OR sequence < ?8) ORDER BY sequence DESC "
                             "LIMIT max(?7, 0)");
    rows.with(to_json(filter.processes), state_words(filter.states), filter.created_from,
              filter.created_to, filter.least_s.value_or(-1), filter.most_s.value_or(-1),
              filter.limit, filter.before);
    while (rows.next()) found.push_back(status_from(rows));
    return found;
  });
}

int Store::count_jobs(const JobFilter& filter) const {
  return connection_->read([&](Database& database) {
    Query row(database, "SELECT count(*) FROM jobs " + filtered);
    row.with(to_json(filter.processes), state_words(filter.states), filter.created_from,
             filter.created_to, filter.least_s.value_or(-1), filter.most_s.value_or(-1));
    row.next();
    return row.small_integer();
  });
}

std::vector<JobStatus> Store::unfinished_jobs() const {
  return connection_->read([&](Database& database) {
    std::vector<JobStatus> found;
    Query rows(database,
               without_request + "WHERE state IN ('accepted', 'running') ORDER BY sequence");
    while (rows.next()) found.push_back(status_from(rows));
    return found;
  });
}

namespace {

bool change_state(Database& database, const std::string& id, JobState state,
                  const std::string& message) {
  // A job taken up again starts and finishes anew; its first start is remembered in the runs.
  const int changed =
      Query(database,
            "UPDATE jobs SET state = ?2, message = ?3, updated = ?4, "
            "progress = CASE ?2 WHEN 'successful' THEN 100 WHEN 'accepted' THEN 0 "
            "  ELSE progress END, "
            "started = CASE ?2 WHEN 'accepted' THEN NULL WHEN 'running' THEN "
            "  coalesce(started, ?4) ELSE started END, "
            "finished = CASE WHEN ?2 IN ('successful', 'failed', 'dismissed') THEN ?4 END "
            "WHERE id = ?1 AND (state <> 'dismissed' OR ?2 IN ('accepted', 'dismissed'))")
          .with(id, to_string(state), message, utc_now())
          .run();
  if (changed > 0) return true;
  Query row(database, "SELECT 1 FROM jobs WHERE id = ?");
  if (!row.with(id).next()) throw StoreError("no job \"" + id + "\" in the store");
  return false;
}

}  // namespace

bool Store::set_job_state(const std::string& id, JobState state, const std::string& message) {
  return connection_->write(
      [&](Database& database) { return change_state(database, id, state, message); });
}

void Store::dismiss_job(const std::string& id) {
  connection_->write([&](Database& database) {
    Query(database,
          "DELETE FROM zones WHERE job_id IN "
          "(SELECT id FROM jobs WHERE id = ? AND state IN ('accepted', 'running'))")
        .with(id)
        .run();
    change_state(database, id, JobState::dismissed, "dismissed");
    const std::string reason = "the job was dismissed";
    Query(database,
          "UPDATE runs SET finished = ?2, outcome = 'dismissed', reason = ?3 "
          "WHERE outcome IS NULL AND section_id IN (SELECT id FROM sections "
          "  WHERE job_id = ?1 AND state IN ('waiting', 'running'))")
        .with(id, utc_now(), reason)
        .run();
    Query(database,
          "UPDATE sections SET state = 'dismissed', reason = ?2 "
          "WHERE job_id = ?1 AND state IN ('waiting', 'running')")
        .with(id, reason)
        .run();
  });
}

int Store::retry_job(const std::string& id) {
  return connection_->write([&](Database& database) {
    // The try of a failed section is booked already.
    Query(
        database,
        "UPDATE sections SET state = 'waiting', reason = '' WHERE job_id = ? AND state = 'failed'")
        .with(id)
        .run();
    Query row(database, "SELECT count(*) FROM sections WHERE job_id = ? AND state = 'waiting'");
    row.with(id).next();
    const int waiting = row.small_integer();
    if (waiting > 0) change_state(database, id, JobState::accepted, "retried");
    return waiting;
  });
}

void Store::set_job_progress(const std::string& id, int progress, const std::string& message) {
  connection_->write([&](Database& database) {
    Query(database,
          "UPDATE jobs SET progress = min(max(?2, 0), 100), message = ?3, updated = ?4 "
          "WHERE id = ?1 AND state IN ('accepted', 'running')")
        .with(id, progress, message, utc_now())
        .run();
  });
}

}  // namespace leda::db
