// Sections: the layout of a job and the state of each of its sections.

#include <utility>

#include "db/connection.hpp"
#include "db/json_text.hpp"
#include "db/section_row.hpp"
#include "db/store.hpp"

namespace leda::db {

namespace {

std::string select_with(const std::string& ground, const std::string& results) {
  return "SELECT sections.id, sections.job_id, sections.ordinal, sections.name, ground.line, "
         "ground.position_m, ground.trace, " +
         ground +
         ", ground.crest_x_m, ground.crest_z_m, ground.toe_x_m, ground.toe_z_m, "
         "sections.state, sections.reason, sections.screening, sections.warnings, "
         "sections.latest_run_id, "
         "(SELECT count(*) FROM runs WHERE runs.section_id = sections.id), "
         "sections.member_of, ground.name, sections.member, sections.member_repeat, "
         "sections.member_finer, " +
         results +
         " FROM sections JOIN sections AS ground ON ground.job_id = sections.job_id "
         "AND ground.ordinal = coalesce(sections.member_of, sections.ordinal) "
         "LEFT JOIN results ON results.run_id = sections.latest_run_id "
         "LEFT JOIN placements ON placements.run_id = results.run_id ";
}

std::optional<MemberRecord> member_from(Query& row) {
  const bool is_section = row.is_null();
  const MemberRecord member{.of = row.small_integer(),
                            .section = row.text(),
                            .number = row.small_integer(),
                            .repeat = row.small_integer(),
                            .finer = row.integer() != 0};
  return is_section ? std::nullopt : std::optional(member);
}

std::string without(std::string columns, const std::string& column) {
  return columns.replace(columns.find(column), column.size(), "'[]'");
}

}  // namespace

const std::string& select_sections() {
  static const std::string select = select_with("ground.ground", result_columns());
  return select;
}

const std::string& select_sections_without_ground() {
  static const std::string select =
      select_with("'[]'", without(result_columns(), "results.profile_after"));
  return select;
}

SectionRecord section_from(Query& row) {
  SectionRecord section{.id = row.integer(),
                        .job = row.text(),
                        .ordinal = row.small_integer(),
                        .name = row.text(),
                        .line = row.small_integer(),
                        .order = row.real(),
                        .trace = map_line_from_json(row.text()),
                        .ground = polyline_from_json(row.text()),
                        .crest = {row.real(), row.real()},
                        .toe = {row.real(), row.real()},
                        .state = section_state_from(row.text()).value(),
                        .reason = row.text(),
                        .screening = row.text(),
                        .warnings = words_from_json(row.text()),
                        .run = row.text(),
                        .attempts = row.small_integer(),
                        .result = std::nullopt,
                        .placed = std::nullopt,
                        .member = member_from(row)};
  read_result(row, section);
  return section;
}

SectionState state_of_section(Database& database, std::int64_t section) {
  Query row(database, "SELECT state FROM sections WHERE id = ?");
  if (!row.with(section).next())
    throw StoreError("no section " + std::to_string(section) + " in the store");
  return section_state_from(row.text()).value();
}

namespace {

// A try whose section goes back to waiting failed where a reason is given, else it was cut off.
const char* outcome_of_try(SectionState state, const std::string& reason) {
  if (state == SectionState::failed || state == SectionState::dismissed) return to_string(state);
  return reason.empty() ? "interrupted" : "failed";
}

}  // namespace

namespace {

void insert_section(Database& database, const std::string& job, const SectionRecord& s) {
  Query(database,
        "INSERT INTO sections (job_id, ordinal, name, line, position_m, trace, ground, "
        "crest_x_m, crest_z_m, toe_x_m, toe_z_m, state, reason, screening, warnings) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .with(job, s.ordinal, s.name, s.line, s.order, to_json(s.trace), to_json(s.ground), s.crest.x,
            s.crest.z, s.toe.x, s.toe.z, to_string(s.state), s.reason,
            s.screening.empty() ? std::nullopt : std::optional(s.screening), to_json(s.warnings))
      .run();
}

void insert_member(Database& database, const std::string& job, const SectionRecord& s) {
  const MemberRecord& member = *s.member;
  Query(database,
        "INSERT INTO sections (job_id, ordinal, name, line, trace, ground, state, reason, "
        "warnings, member_of, member, member_repeat, member_finer) "
        "VALUES (?, ?, ?, -1, '[]', '[]', ?, ?, '[]', ?, ?, ?, ?)")
      .with(job, s.ordinal, s.name, to_string(s.state), s.reason, member.of, member.number,
            member.repeat, member.finer)
      .run();
}

}  // namespace

bool Store::set_sections(const std::string& job, const std::vector<SectionRecord>& sections) {
  return connection_->write([&](Database& database) {
    Query standing(database, "SELECT 1 FROM sections WHERE job_id = ? LIMIT 1");
    if (standing.with(job).next()) return false;
    for (const SectionRecord& s : sections) {
      if (s.member) {
        insert_member(database, job, s);
      } else {
        insert_section(database, job, s);
      }
    }
    return true;
  });
}

std::vector<SectionRecord> Store::sections(const std::string& job) const {
  return connection_->read([&](Database& database) {
    std::vector<SectionRecord> all;
    Query rows(database, select_sections() +
                             "WHERE sections.job_id = ? AND sections.member_of IS NULL "
                             "ORDER BY sections.ordinal");
    rows.with(job);
    while (rows.next()) all.push_back(section_from(rows));
    return all;
  });
}

std::vector<SectionRecord> Store::members(const std::string& job, int section) const {
  return connection_->read([&](Database& database) {
    std::vector<SectionRecord> all;
    Query rows(database, select_sections_without_ground() +
                             "WHERE sections.job_id = ? AND sections.member_of = ? "
                             "ORDER BY sections.ordinal");
    rows.with(job, section);
    while (rows.next()) all.push_back(section_from(rows));
    return all;
  });
}

// An index holds all of this: no row of a section is read.
std::vector<SectionInLine> Store::sections_in_line(const std::string& job) const {
  return connection_->read([&](Database& database) {
    std::vector<SectionInLine> all;
    Query rows(database,
               "SELECT id, state, member_of IS NOT NULL FROM sections WHERE job_id = ? "
               "ORDER BY id");
    rows.with(job);
    while (rows.next())
      all.push_back({.id = rows.integer(),
                     .state = section_state_from(rows.text()).value(),
                     .is_member = rows.integer() != 0});
    return all;
  });
}

std::optional<SectionRecord> Store::section(const std::string& job, const std::string& name) const {
  return connection_->read([&](Database& database) -> std::optional<SectionRecord> {
    Query row(database, select_sections() + "WHERE sections.job_id = ? AND sections.name = ?");
    if (!row.with(job, name).next()) return std::nullopt;
    return section_from(row);
  });
}

std::optional<SectionRecord> Store::section(std::int64_t section) const {
  return connection_->read([&](Database& database) -> std::optional<SectionRecord> {
    Query row(database, select_sections() + "WHERE sections.id = ?");
    if (!row.with(section).next()) return std::nullopt;
    return section_from(row);
  });
}

void Store::set_screening(std::int64_t section, const std::string& screening) {
  connection_->write([&](Database& database) {
    Query(database, "UPDATE sections SET screening = ?2 WHERE id = ?1")
        .with(section, screening)
        .run();
  });
}

bool Store::set_section_state(std::int64_t section, SectionState state, const std::string& reason) {
  return connection_->write([&](Database& database) {
    const SectionState now = state_of_section(database, section);
    if (now == SectionState::finished || now == SectionState::dismissed) return false;
    if (state == SectionState::finished)
      throw StoreError("a section is finished by its result (take_in), not by a word");
    if (state != SectionState::running)
      close_run(database, section, outcome_of_try(state, reason), reason);
    Query(database, "UPDATE sections SET state = ?2, reason = ?3 WHERE id = ?1")
        .with(section, to_string(state), reason)
        .run();
    return true;
  });
}

}  // namespace leda::db
