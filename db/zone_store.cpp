// Zones: the product of a job.

#include <map>

#include "db/connection.hpp"
#include "db/json_text.hpp"
#include "db/store.hpp"

namespace leda::db {

namespace {

void insert_zone(Database& database, const std::string& job, int ordinal, const Zone& zone) {
  Query insert(database,
               "INSERT INTO zones (job_id, ordinal, kind, area, largest_distance_m, "
               "mean_distance_m, warnings, made_by) VALUES (?, ?, ?, ?, ?, ?, ?, ?) "
               "RETURNING id");
  insert.with(job, ordinal, zone.kind == ZoneKind::release ? "release" : "runout",
              to_json(zone.area), zone.largest_distance_m, zone.mean_distance_m,
              to_json(zone.warnings), zone.made_by);
  insert.next();
  const std::int64_t id = insert.integer();
  for (std::size_t i = 0; i < zone.sections.size(); ++i)
    Query(database,
          "INSERT INTO zone_sections (zone_id, ordinal, job_id, section) VALUES (?, ?, ?, ?)")
        .with(id, static_cast<int>(i), job, zone.sections[i])
        .run();
}

std::map<std::int64_t, std::vector<std::string>> sections_of_zones(Database& database,
                                                                   const std::string& job) {
  std::map<std::int64_t, std::vector<std::string>> names;
  Query rows(database,
             "SELECT zone_id, section FROM zone_sections WHERE job_id = ? "
             "ORDER BY zone_id, ordinal");
  rows.with(job);
  while (rows.next()) {
    const std::int64_t zone = rows.integer();
    names[zone].push_back(rows.text());
  }
  return names;
}

}  // namespace

void Store::set_zones(const std::string& job, const std::vector<Zone>& zones) {
  connection_->write([&] {
    Query(*connection_, "DELETE FROM zones WHERE job_id = ?").with(job).run();
    for (std::size_t i = 0; i < zones.size(); ++i)
      insert_zone(*connection_, job, static_cast<int>(i), zones[i]);
  });
}

std::vector<ZoneRecord> Store::zones(const std::string& job) const {
  return connection_->read([&] {
    auto names = sections_of_zones(*connection_, job);
    std::vector<ZoneRecord> all;
    Query rows(*connection_,
               "SELECT id, kind, area, largest_distance_m, mean_distance_m, warnings, made_by "
               "FROM zones WHERE job_id = ? ORDER BY ordinal");
    rows.with(job);
    while (rows.next()) {
      ZoneRecord record{.id = rows.integer(), .job = job, .zone = {}};
      record.zone = Zone{.kind = rows.text() == "release" ? ZoneKind::release : ZoneKind::runout,
                         .area = area_from_json(rows.text()),
                         .sections = std::move(names[record.id]),
                         .largest_distance_m = rows.real(),
                         .mean_distance_m = rows.real(),
                         .warnings = words_from_json(rows.text()),
                         .made_by = rows.text()};
      all.push_back(std::move(record));
    }
    return all;
  });
}

}  // namespace leda::db
