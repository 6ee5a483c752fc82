// Pages of sections and zones over one job or all, and where features lie.

#include "db/feature_page.hpp"

#include "db/connection.hpp"
#include "db/section_row.hpp"

namespace leda::db {

namespace {

std::string singular(const std::string& table) { return table.substr(0, table.size() - 1); }

std::string join_boxes(const std::string& table) {
  const std::string one = singular(table);
  return one + "_boxes AS box ON box." + one + "_id = " + table + ".id ";
}

// Either box may cross 180 degrees: its west is then beyond its east.
constexpr const char* overlaps =
    "box.south <= ?5 AND box.north >= ?3 AND (CASE WHEN ?2 <= ?4 AND box.west <= box.east "
    "THEN box.west <= ?4 AND box.east >= ?2 "
    "ELSE (?2 > ?4 AND box.west > box.east) OR box.west <= ?4 OR box.east >= ?2 END) AND ";

/// Ids of features whose box may overlap the one that was asked for, which goes on to an east
/// beyond 180 degrees (?9) as those in the tree do: so it is looked for a turn around as well.
std::string near_the_box(const std::string& table) {
  std::string text = table + ".id IN (";
  for (const char* turn : {"- 360", "+ 0", "+ 360"}) {
    if (!text.ends_with('(')) text += " UNION ALL ";
    text += "SELECT id FROM " + singular(table) + "_tree WHERE west <= ?9 " + turn +
            " AND east >= ?2 " + turn + " AND south <= ?5 AND north >= ?3";
  }
  return text + ") AND ";
}

constexpr const char* no_members = "sections.member_of IS NULL AND ";

constexpr const char* of_shown_jobs =
    "JOIN jobs ON jobs.id = %.job_id AND jobs.state = 'successful' AND jobs.raster_id IS NOT NULL ";

constexpr const char* of_any_shown_job =
    ".job_id IN (SELECT id FROM jobs WHERE state = 'successful' AND raster_id IS NOT NULL) "
    "AND ?1 = '' ";

std::string with_table(std::string text, const std::string& table) {
  for (auto at = text.find('%'); at != std::string::npos; at = text.find('%'))
    text.replace(at, 1, table);
  return text;
}

void set_boxes(Database& database, const std::string& one, const std::vector<FeatureBox>& boxes) {
  const std::string insert = "INSERT OR REPLACE INTO " + one + "_boxes (" + one +
                             "_id, west, south, east, north) VALUES (?, ?, ?, ?, ?)";
  database.write([&] {
    for (const FeatureBox& b : boxes) {
      Query(database, insert).with(b.id, b.box[0], b.box[1], b.box[2], b.box[3]).run();
    }
  });
}

}  // namespace

// The statements are put together from fixed parts alone: what a client sends is bound, never
// pasted.
std::string matches(const std::string& table, const PageFilter& filter,
                    const std::string& condition, bool in_order) {
  std::string text;
  if (filter.box) text += "JOIN " + join_boxes(table);
  text += "WHERE " + condition;
  if (filter.box) text += near_the_box(table) + overlaps;
  if (filter.id) text += table + ".id = ?6 AND ";
  if (!filter.job.empty()) return text + table + ".job_id = ?1 ";
  // The plus keeps SQLite from the index by job, with which it would have to sort.
  return text + (in_order ? "+" : "") + table + of_any_shown_job;
}

// In an order that an index has, so that SQLite reads no more rows than the page needs: sorted, a
// page of ten reads all rows of its job, and beyond an offset it reads all before it.
std::string page_of(const std::string& table, const PageFilter& filter,
                    const std::string& condition) {
  return matches(table, filter, condition, true) + "AND " + table + ".id > ?8 ORDER BY " + table +
         ".id LIMIT max(?7, 0)";
}

bool may_find(Database& database, const PageFilter& filter) {
  if (!filter.job.empty()) return true;
  return Query(database,
               "SELECT 1 FROM jobs WHERE state = 'successful' AND raster_id IS NOT NULL LIMIT 1")
      .next();
}

void bind_page(Query& query, const PageFilter& filter) {
  const MapBox box = filter.box.value_or(MapBox{});
  const double unrolled_east = box[2] + (box[0] > box[2] ? 360 : 0);
  query.with_some(filter.job, box[0], box[1], box[2], box[3], filter.id.value_or(0), filter.limit,
                  filter.after, unrolled_east);
}

Coverage coverage_of(Database& database, const std::string& table, const std::string& condition) {
  const std::string from = "FROM " + table + " " + with_table(of_shown_jobs, table) + "LEFT JOIN " +
                           join_boxes(table) + "WHERE " + condition + "TRUE";
  Coverage coverage;
  Query row(
      database,
      "SELECT count(*), CASE WHEN max(box.west > box.east) THEN -180.0 ELSE min(box.west) END, "
      "min(box.south), CASE WHEN max(box.west > box.east) THEN 180.0 ELSE max(box.east) END, "
      "max(box.north) " +
          from);
  row.next();
  coverage.features = row.small_integer();
  if (!row.is_null()) coverage.box = MapBox{row.real(), row.real(), row.real(), row.real()};
  Query codes(database,
              "SELECT DISTINCT rasters.epsg FROM rasters JOIN jobs ON jobs.raster_id = rasters.id "
              "WHERE jobs.state = 'successful' AND EXISTS (SELECT 1 FROM " +
                  table + " WHERE " + table + ".job_id = jobs.id) ORDER BY 1");
  while (codes.next()) coverage.epsg.push_back(codes.small_integer());
  return coverage;
}

std::vector<SectionRecord> Store::section_page(const PageFilter& filter) const {
  return connection_->read([&](Database& database) {
    std::vector<SectionRecord> page;
    if (!may_find(database, filter)) return page;
    Query rows(database,
               select_sections_without_ground() + page_of("sections", filter, no_members));
    bind_page(rows, filter);
    while (rows.next()) page.push_back(section_from(rows));
    return page;
  });
}

int Store::count_sections(const PageFilter& filter) const {
  return connection_->read([&](Database& database) {
    if (!may_find(database, filter)) return 0;
    Query row(database,
              "SELECT count(*) FROM sections " + matches("sections", filter, no_members, false));
    bind_page(row, filter);
    row.next();
    return row.small_integer();
  });
}

int Store::count_sections(SectionState state) const {
  return connection_->read([&](Database& database) {
    // The state stands in the text, not in a parameter: only so the partial index is used.
    Query row(database, std::string("SELECT count(*) FROM sections WHERE state = '") +
                            to_string(state) + "'");
    row.next();
    return row.small_integer();
  });
}

void Store::set_section_boxes(const std::vector<FeatureBox>& boxes) {
  set_boxes(connection_->writer(), "section", boxes);
}

void Store::set_zone_boxes(const std::vector<FeatureBox>& boxes) {
  set_boxes(connection_->writer(), "zone", boxes);
}

std::vector<std::string> Store::jobs_without_boxes() const {
  return connection_->read([&](Database& database) {
    std::vector<std::string> jobs;
    Query rows(database,
               "SELECT id FROM jobs WHERE raster_id IS NOT NULL AND ("
               "EXISTS (SELECT 1 FROM sections WHERE job_id = jobs.id AND member_of IS NULL "
               "        AND id NOT IN "
               "        (SELECT section_id FROM section_boxes)) OR "
               "EXISTS (SELECT 1 FROM zones WHERE job_id = jobs.id AND id NOT IN "
               "        (SELECT zone_id FROM zone_boxes))) ORDER BY sequence");
    while (rows.next()) jobs.push_back(rows.text());
    return jobs;
  });
}

Coverage Store::section_coverage() const {
  return connection_->read(
      [&](Database& database) { return coverage_of(database, "sections", no_members); });
}

}  // namespace leda::db
