// Rasters: the registered DEMs.

#include "db/connection.hpp"
#include "db/json_text.hpp"
#include "db/store.hpp"

namespace leda::db {

namespace {

const std::string columns =
    "SELECT id, name, file, sha256, epsg, cell_x, cell_y, width_cells, height_cells, "
    "west, south, east, north, vertical_unit, created, lowest_m, highest_m, share_without_data, "
    "cell_ground_x_m, cell_ground_y_m, undeclared_fill_m, warnings, removed FROM rasters ";

RasterRecord raster_from(Query& row) {
  return RasterRecord{.id = row.text(),
                      .name = row.text(),
                      .file = row.text(),
                      .sha256 = row.text(),
                      .epsg = row.small_integer(),
                      .cell_x = row.real(),
                      .cell_y = row.real(),
                      .width = row.small_integer(),
                      .height = row.small_integer(),
                      .box = {row.real(), row.real(), row.real(), row.real()},
                      .vertical_unit = row.text(),
                      .created = row.text(),
                      .lowest_m = row.optional_real(),
                      .highest_m = row.optional_real(),
                      .share_without_data = row.optional_real(),
                      .cell_ground_x_m = row.optional_real(),
                      .cell_ground_y_m = row.optional_real(),
                      .undeclared_fill_m = row.optional_real(),
                      .warnings = words_from_json(row.text()),
                      .removed = row.text()};
}

}  // namespace

void Store::add_raster(const RasterRecord& r) {
  connection_->write([&](Database& database) {
    Query(database,
          "INSERT INTO rasters (id, name, file, sha256, epsg, cell_x, cell_y, width_cells, "
          "height_cells, west, south, east, north, vertical_unit, created, lowest_m, highest_m, "
          "share_without_data, cell_ground_x_m, cell_ground_y_m, undeclared_fill_m, warnings) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
          "ON CONFLICT (id) DO UPDATE SET name = excluded.name, file = excluded.file, "
          "sha256 = excluded.sha256, epsg = excluded.epsg, cell_x = excluded.cell_x, "
          "cell_y = excluded.cell_y, width_cells = excluded.width_cells, "
          "height_cells = excluded.height_cells, west = excluded.west, south = excluded.south, "
          "east = excluded.east, north = excluded.north, "
          "vertical_unit = excluded.vertical_unit, created = excluded.created, "
          "lowest_m = excluded.lowest_m, highest_m = excluded.highest_m, "
          "share_without_data = excluded.share_without_data, "
          "cell_ground_x_m = excluded.cell_ground_x_m, "
          "cell_ground_y_m = excluded.cell_ground_y_m, "
          "undeclared_fill_m = excluded.undeclared_fill_m, warnings = excluded.warnings, "
          "removed = NULL")
        .with(r.id, r.name, r.file, r.sha256, r.epsg, r.cell_x, r.cell_y, r.width, r.height,
              r.box[0], r.box[1], r.box[2], r.box[3], r.vertical_unit,
              r.created.empty() ? utc_now() : r.created, r.lowest_m, r.highest_m,
              r.share_without_data, r.cell_ground_x_m, r.cell_ground_y_m, r.undeclared_fill_m,
              to_json(r.warnings))
        .run();
  });
}

std::vector<RasterRecord> Store::rasters() const {
  return connection_->read([&](Database& database) {
    std::vector<RasterRecord> all;
    Query rows(database, columns + "WHERE removed IS NULL ORDER BY sequence");
    while (rows.next()) all.push_back(raster_from(rows));
    return all;
  });
}

std::optional<RasterRecord> Store::raster(const std::string& id_or_name) const {
  return connection_->read([&](Database& database) -> std::optional<RasterRecord> {
    Query row(database, columns + "WHERE id = ?1 OR name = ?1 ORDER BY id = ?1 DESC LIMIT 1");
    if (!row.with(id_or_name).next()) return std::nullopt;
    return raster_from(row);
  });
}

bool Store::rename_raster(const std::string& id, const std::string& name) {
  return connection_->write([&](Database& database) {
    return Query(database, "UPDATE rasters SET name = ?2 WHERE id = ?1 AND removed IS NULL")
               .with(id, name)
               .run() > 0;
  });
}

bool Store::remove_raster(const std::string& id) {
  return connection_->write([&](Database& database) {
    Query needed(database,
                 "SELECT 1 FROM jobs WHERE raster_id = ? AND state IN ('accepted', 'running')");
    if (needed.with(id).next()) return false;
    Query(database,
          "DELETE FROM rasters WHERE id = ?1 "
          "AND NOT EXISTS (SELECT 1 FROM jobs WHERE raster_id = ?1)")
        .with(id)
        .run();
    // A name is unique, and this one is free again: no other raster is called as an id is.
    Query(database, "UPDATE rasters SET removed = ?2, name = id WHERE id = ?1")
        .with(id, utc_now())
        .run();
    return true;
  });
}

}  // namespace leda::db
