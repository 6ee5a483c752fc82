// An upgrade loses nothing: a store of the first schema, with rows in every table, is opened by
// this Leda, and everything that stood in it stands there still.

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "db/database.hpp"
#include "db/migrate.hpp"
#include "db/store.hpp"
#include "tests/db/samples.hpp"

namespace leda::db {
namespace {

using namespace std::chrono_literals;
using samples::ScratchFolder;

constexpr const char* rows_of_the_first_schema = R"(
INSERT INTO rasters (id, name, file, sha256, epsg, cell_x, cell_y, width_cells, height_cells,
  west, south, east, north, vertical_unit, created) VALUES
  ('dem-0123456789ab', 'valley', 'rasters/dem-0123456789ab.tif', 'aa', 2950, 1, 1, 100, 50,
   0, 0, 100, 50, 'm', '2026-01-01T00:00:00.000Z');
INSERT INTO jobs (id, process, name, state, message, progress, request, idempotency_key, raster_id,
  created, started, finished, updated) VALUES
  ('done', 'map-region', 'a valley', 'successful', '3 sections', 100, '{"inputs":{}}', 'key-1',
   'dem-0123456789ab', '2026-01-01T00:00:00.000Z', '2026-01-01T00:00:01.000Z',
   '2026-01-01T00:01:00.000Z', '2026-01-01T00:01:00.000Z'),
  ('going', 'map-region', 'cut off', 'running', '1 of 1 under way', 40, '{"inputs":{}}', NULL,
   'dem-0123456789ab', '2026-01-02T00:00:00.000Z', '2026-01-02T00:00:01.000Z', NULL,
   '2026-01-02T00:00:02.000Z');
INSERT INTO sections (id, job_id, ordinal, name, line, position_m, trace, ground, crest_x_m,
  crest_z_m, toe_x_m, toe_z_m, state, reason, screening, warnings, latest_run_id) VALUES
  (7, 'done', 0, 'AA''', -1, NULL, '[[0,10],[90,10]]', '[[0,20],[40,20],[60,8],[90,8]]', 40, 20, 60,
   8, 'finished', '', '{"decision":"simulate"}', '["a warning"]', 'done-0-2'),
  (8, 'done', 1, 'S001', 0, 12.5, '[[0,20],[90,20]]', '[[0,20],[90,8]]', NULL, NULL, NULL, NULL,
   'left_out', 'no bank', NULL, '[]', NULL),
  (9, 'done', 2, 'S002', 0, 25, '[[0,30],[90,30]]', '[[0,20],[90,8]]', 40, 20, 60, 8, 'failed',
   'the energy audit failed', NULL, '[]', 'done-2-1'),
  (10, 'going', 0, 'BB''', -1, NULL, '[[0,40],[90,40]]', '[[0,20],[40,20],[60,8],[90,8]]', 40, 20,
   60, 8, 'running', '', NULL, '[]', 'going-0-1');
INSERT INTO runs (id, section_id, attempt, started, finished, outcome, reason) VALUES
  ('done-0-1', 7, 1, '2026-01-01T00:00:02.000Z', '2026-01-01T00:00:03.000Z', 'failed', 'signal 9'),
  ('done-0-2', 7, 2, '2026-01-01T00:00:04.000Z', '2026-01-01T00:00:30.000Z', 'result', ''),
  ('done-2-1', 9, 1, '2026-01-01T00:00:04.000Z', '2026-01-01T00:00:30.000Z', 'unstable', 'energy'),
  ('going-0-1', 10, 1, '2026-01-02T00:00:02.000Z', NULL, NULL, '');
INSERT INTO results VALUES
  ('done-0-2', 7, 'at-rest', '', 12.5, 3.5, 23.5, 40, 20, 60, 8, 27.5, 20, 63.5, 8, 'undrained', 2,
   61, 26, 24000, 41000, 26.4, 0, 1e-12, 0.004, 0.1, '[[0,20],[27.5,20],[63.5,8],[90,8]]',
   '["the front reached the model''s edge: runout is a lower bound"]', 'cc', '0.1.0', '2026-01-01T00:00:30.000Z', '{"status":"at-rest"}'),
  ('done-2-1', 9, 'unstable', 'the energy audit failed', NULL, NULL, NULL, 40, 20, 60, 8, NULL, NULL,
   NULL, NULL, 'undrained', 0, 1, 26, 24, 41, NULL, 0, 0, 3, NULL, '[]', '["w"]', 'dd', '0.1.0',
   '2026-01-01T00:00:30.000Z', '{"status":"unstable"}');
INSERT INTO placements VALUES
  ('done-0-2', 1, 1, 27.5, 10, 40, 10, 60, 10, 63.5, 10, 12.5, 3.5, '[]', 'cc 0.1.0');
INSERT INTO zones (id, job_id, ordinal, kind, area, largest_distance_m, mean_distance_m, warnings,
  made_by) VALUES
  (3, 'done', 0, 'release', '[[[[27.5,5],[40,5],[40,15],[27.5,15],[27.5,5]]]]', 12.5, 12.5, '[]',
   'ee'),
  (4, 'done', 1, 'runout', '[[[[60,5],[63.5,5],[63.5,15],[60,15],[60,5]]]]', 3.5, 3.5, '[]', 'ee');
INSERT INTO zone_sections VALUES (3, 0, 'done', 'AA'''), (4, 0, 'done', 'AA''');
)";

std::vector<std::string> texts(Database& database, const std::string& sql) {
  std::vector<std::string> found;
  Query query(database, sql);
  while (query.next()) found.push_back(query.text());
  return found;
}

/// Every row of every table as SQLite writes its values, by table; the columns are the given ones.
using Columns = std::map<std::string, std::string>;

Columns columns_of(Database& database) {
  Columns columns;
  database.read([&] {
    for (const auto& table : texts(database,
                                   "SELECT name FROM sqlite_schema WHERE type = 'table' AND name "
                                   "NOT LIKE 'sqlite_%'")) {
      std::string list;
      for (const auto& column :
           texts(database, "SELECT name FROM pragma_table_info('" + table + "')")) {
        list += (list.empty() ? "quote(" : " || ',' || quote(") + column + ")";
      }
      columns[table] = list;
    }
  });
  return columns;
}

std::map<std::string, std::vector<std::string>> rows_of(Database& database,
                                                        const Columns& columns) {
  std::map<std::string, std::vector<std::string>> rows;
  database.read([&] {
    for (const auto& [table, list] : columns) {
      rows[table] = texts(
          database,
          std::string("SELECT ").append(list).append(" FROM ").append(table).append(" ORDER BY 1"));
    }
  });
  return rows;
}

class Upgrade : public testing::Test {
 protected:
  void SetUp() override {
    Database first(file, 1s);
    migrate(first, {migrations().front()});
    first.write([&] { first.run_script(rows_of_the_first_schema); });
    columns = columns_of(first);
    before = rows_of(first, columns);
  }

  ScratchFolder folder;
  std::filesystem::path file = folder / "leda.sqlite";
  Columns columns;
  std::map<std::string, std::vector<std::string>> before;
};

TEST_F(Upgrade, TheFirstSchemaHasARowInEveryTable) {
  EXPECT_EQ(before.size(), 8U);
  for (const auto& [table, rows] : before) EXPECT_FALSE(rows.empty()) << table;
}

TEST_F(Upgrade, EveryValueOfEveryRowStays) {
  { Store store(file); }
  Database now(file, 1s);
  // Requests have a table of their own.
  const std::string requests = "(SELECT * FROM jobs JOIN requests USING (sequence))";
  columns[requests] = std::exchange(columns["jobs"], "quote(id)");
  before[requests] = std::exchange(before["jobs"], {"'done'", "'going'"});
  EXPECT_EQ(rows_of(now, columns), before);
  now.read([&] {
    EXPECT_TRUE(
        texts(now, "SELECT 1 FROM pragma_table_info('jobs') WHERE name = 'request'").empty())
        << "whoever reads or writes the row of a job walks the pages of its request";
    EXPECT_EQ(texts(now, "PRAGMA integrity_check"), std::vector<std::string>{"ok"});
    EXPECT_TRUE(texts(now, "PRAGMA foreign_key_check").empty());
    EXPECT_EQ(texts(now, "SELECT retrogression_is FROM results ORDER BY run_id"),
              (std::vector<std::string>{"measured", "lower-bound"}))
        << "a run that came to rest, and an unstable one";
    EXPECT_EQ(texts(now, "PRAGMA user_version")[0], std::to_string(migrations().back().version));
  });
}

TEST_F(Upgrade, TheOldRowsAreReadAndGoOn) {
  Store store(file);
  EXPECT_EQ(store.raster("valley")->id, "dem-0123456789ab");
  EXPECT_EQ(store.job_by_idempotency_key("key-1")->id, "done");
  EXPECT_EQ(store.job("done")->request, R"({"inputs":{}})");
  const auto section = store.section("done", "AA'");
  ASSERT_TRUE(section && section->result && section->placed);
  EXPECT_DOUBLE_EQ(section->result->crest_to_crest_retrogression_m, 12.5);
  EXPECT_FALSE(section->result->engine) << "nobody knows what computed it";
  EXPECT_EQ(section->attempts, 2);
  // What the first schema did not say is read from the status and the warnings.
  EXPECT_EQ(section->result->retrogression_is, Bound::measured);
  EXPECT_EQ(section->result->runout_is, Bound::lower_bound);
  EXPECT_EQ(store.zones("done").at(0).zone.distance_is, Bound::measured);
  EXPECT_EQ(store.zones("done").at(1).zone.distance_is, Bound::lower_bound);
  EXPECT_EQ(store.zones("done").size(), 2U);
  // What was under way when the old server ended is taken up.
  ASSERT_EQ(store.unfinished_jobs().size(), 1U);
  EXPECT_TRUE(store.set_section_state(10, SectionState::waiting, ""));
  EXPECT_TRUE(store.start_run(10, "going-0-2"));
  EXPECT_EQ(store.runs(10).size(), 2U);
  // The server fills in on its start what the first schema did not have.
  EXPECT_EQ(store.jobs_without_boxes().size(), 2U);
}

}  // namespace
}  // namespace leda::db
