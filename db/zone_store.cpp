// Zones: the product of a job.

#include "db/connection.hpp"
#include "db/feature_page.hpp"
#include "db/json_text.hpp"
#include "db/store.hpp"

namespace leda::db {

namespace {

/// Which zones a layer shows; ends with AND.
std::string in_layer(ZoneLayer layer) {
  if (layer == ZoneLayer::probability) return "zones.exceedance IS NOT NULL AND ";
  const char* kind = layer == ZoneLayer::release ? "release" : "runout";
  return std::string("zones.kind = '") + kind + "' AND zones.exceedance IS NULL AND ";
}

void insert_zone(Database& database, const std::string& job, int ordinal, const Zone& zone) {
  Query insert(database,
               "INSERT INTO zones (job_id, ordinal, kind, area, largest_distance_m, "
               "mean_distance_m, distance_is, warnings, made_by, exceedance, members) "
               "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
               "RETURNING id");
  const auto& p = zone.probability;
  insert.with(job, ordinal, to_string(zone.kind), to_json(zone.area), zone.largest_distance_m,
              zone.mean_distance_m, to_string(zone.distance_is), to_json(zone.warnings),
              zone.made_by, p ? std::optional(p->exceedance) : std::nullopt,
              p ? std::optional(p->members) : std::nullopt);
  insert.next();
  const std::int64_t id = insert.integer();
  for (std::size_t i = 0; i < zone.sections.size(); ++i)
    Query(database,
          "INSERT INTO zone_sections (zone_id, ordinal, job_id, section) VALUES (?, ?, ?, ?)")
        .with(id, static_cast<int>(i), job, zone.sections[i])
        .run();
}

// The versions that computed the sections of a zone stand with their results.
const std::string columns =
    "SELECT zones.id, zones.job_id, zones.kind, zones.area, zones.largest_distance_m, "
    "zones.mean_distance_m, zones.distance_is, zones.warnings, zones.made_by, "
    "zones.exceedance, zones.members, "
    "(SELECT group_concat(DISTINCT results.version) FROM zone_sections "
    " JOIN sections ON sections.job_id = zone_sections.job_id "
    "  AND sections.name = zone_sections.section "
    " JOIN results ON results.run_id = sections.latest_run_id "
    " WHERE zone_sections.zone_id = zones.id) FROM zones ";

std::vector<std::string> sections_of_zone(Database& database, std::int64_t zone) {
  std::vector<std::string> names;
  Query rows(database, "SELECT section FROM zone_sections WHERE zone_id = ? ORDER BY ordinal");
  rows.with(zone);
  while (rows.next()) names.push_back(rows.text());
  return names;
}

std::vector<ZoneRecord> zones_from(Database& database, Query& rows) {
  std::vector<ZoneRecord> all;
  while (rows.next()) {
    ZoneRecord record{.id = rows.integer(), .job = rows.text(), .zone = {}, .version = {}};
    record.zone = Zone{.kind = rows.text() == "release" ? ZoneKind::release : ZoneKind::runout,
                       .area = area_from_json(rows.text()),
                       .sections = sections_of_zone(database, record.id),
                       .probability = std::nullopt,
                       .largest_distance_m = rows.real(),
                       .mean_distance_m = rows.real(),
                       .distance_is = bound_from(rows.text()).value(),
                       .warnings = words_from_json(rows.text()),
                       .made_by = rows.text()};
    if (const auto exceedance = rows.optional_real()) {
      record.zone.probability = ZoneProbability{*exceedance, rows.small_integer()};
    } else {
      rows.integer();
    }
    record.version = rows.text();
    all.push_back(std::move(record));
  }
  return all;
}

}  // namespace

void Store::set_zones(const std::string& job, const std::vector<Zone>& zones) {
  connection_->write([&](Database& database) {
    Query dismissed(database, "SELECT 1 FROM jobs WHERE id = ? AND state = 'dismissed'");
    if (dismissed.with(job).next()) return;
    Query(database, "DELETE FROM zones WHERE job_id = ?").with(job).run();
    for (std::size_t i = 0; i < zones.size(); ++i)
      insert_zone(database, job, static_cast<int>(i), zones[i]);
  });
}

std::vector<ZoneRecord> Store::zones(const std::string& job) const {
  return connection_->read([&](Database& database) {
    Query rows(database, columns + "WHERE zones.job_id = ? ORDER BY zones.ordinal");
    rows.with(job);
    return zones_from(database, rows);
  });
}

std::vector<ZoneRecord> Store::zone_page(ZoneLayer layer, const PageFilter& filter) const {
  return connection_->read([&](Database& database) -> std::vector<ZoneRecord> {
    if (!may_find(database, filter)) return {};
    Query rows(database, columns + page_of("zones", filter, in_layer(layer)));
    bind_page(rows, filter);
    return zones_from(database, rows);
  });
}

int Store::count_zones(ZoneLayer layer, const PageFilter& filter) const {
  return connection_->read([&](Database& database) {
    if (!may_find(database, filter)) return 0;
    Query row(database,
              "SELECT count(*) FROM zones " + matches("zones", filter, in_layer(layer), false));
    bind_page(row, filter);
    row.next();
    return row.small_integer();
  });
}

Coverage Store::zone_coverage(ZoneLayer layer) const {
  return connection_->read(
      [&](Database& database) { return coverage_of(database, "zones", in_layer(layer)); });
}

}  // namespace leda::db
