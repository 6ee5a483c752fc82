// Rasters: the registered DEMs.

#include "db/connection.hpp"
#include "db/store.hpp"

namespace leda::db {

namespace {

const std::string columns =
    "SELECT id, name, file, sha256, epsg, cell_x, cell_y, width_cells, height_cells, "
    "west, south, east, north, vertical_unit, created FROM rasters ";

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
                      .created = row.text()};
}

}  // namespace

void Store::add_raster(const RasterRecord& r) {
  connection_->write([&](Database& database) {
    Query(database,
          "INSERT INTO rasters (id, name, file, sha256, epsg, cell_x, cell_y, width_cells, "
          "height_cells, west, south, east, north, vertical_unit, created) "
          "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
          "ON CONFLICT (id) DO UPDATE SET name = excluded.name, file = excluded.file, "
          "sha256 = excluded.sha256, epsg = excluded.epsg, cell_x = excluded.cell_x, "
          "cell_y = excluded.cell_y, width_cells = excluded.width_cells, "
          "height_cells = excluded.height_cells, west = excluded.west, south = excluded.south, "
          "east = excluded.east, north = excluded.north, "
          "vertical_unit = excluded.vertical_unit, created = excluded.created")
        .with(r.id, r.name, r.file, r.sha256, r.epsg, r.cell_x, r.cell_y, r.width, r.height,
              r.box[0], r.box[1], r.box[2], r.box[3], r.vertical_unit,
              r.created.empty() ? utc_now() : r.created)
        .run();
  });
}

std::vector<RasterRecord> Store::rasters() const {
  return connection_->read([&](Database& database) {
    std::vector<RasterRecord> all;
    Query rows(database, columns + "ORDER BY sequence");
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

}  // namespace leda::db
