#include "server/layers/rasters.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "disk/temporary_file.hpp"
#include "profiles/hillshade.hpp"
#include "profiles/proj4_text.hpp"
#include "server/documents/json_syntax.hpp"
#include "server/documents/object_reader.hpp"
#include "server/documents/or_null.hpp"
#include "server/http/handlers/handlers.hpp"
#include "server/http/handlers/parameters.hpp"
#include "server/http/site.hpp"
#include "server/operate/problem.hpp"

namespace leda::server {
namespace {

using nlohmann::json;

/// Metres east and north; null where it is not known.
json ground_cell(const db::RasterRecord& raster) {
  if (!raster.cell_ground_x_m || !raster.cell_ground_y_m) return nullptr;
  return {*raster.cell_ground_x_m, *raster.cell_ground_y_m};
}

json document_of(const db::RasterRecord& raster, const std::string& url) {
  return {
      {"id", raster.id},
      {"name", raster.name},
      {"crs", "EPSG:" + std::to_string(raster.epsg)},
      {"proj4", profiles::proj4_text(raster.epsg)},
      {"cell", {raster.cell_x, raster.cell_y}},
      {"size", {raster.width, raster.height}},
      {"bbox", raster.box},
      {"vertical_unit", raster.vertical_unit},
      {"lowest_m", or_null(raster.lowest_m)},
      {"highest_m", or_null(raster.highest_m)},
      {"share_without_data", or_null(raster.share_without_data)},
      {"cell_on_ground_m", ground_cell(raster)},
      {"undeclared_fill_m", or_null(raster.undeclared_fill_m)},
      {"warnings", raster.warnings},
      {"sha256", raster.sha256},
      {"created", raster.created},
      {"links",
       {{{"href", url + "/rasters/" + raster.id}, {"rel", "self"}, {"type", "application/json"}},
        {{"href", url + "/rasters/" + raster.id + "/hillshade.png"},
         {"rel", "preview"},
         {"type", "image/png"}}}}};
}

/// @throws Problem where it could not be read whole, is empty or too large
void write_body(const Call& call, const std::filesystem::path& file, std::uint64_t most_bytes) {
  std::uint64_t bytes = 0;
  std::ofstream out(file, std::ios::binary);
  const bool whole = call.body([&](const char* data, std::size_t size) {
    bytes += size;
    if (bytes > most_bytes) return true;  // read and dropped
    return static_cast<bool>(out.write(data, static_cast<std::streamsize>(size)));
  });
  out.close();
  if (!whole || !out) {
    throw Problem(Failure::invalid_request, "the body could not be read whole");
  }
  if (bytes > most_bytes) {
    throw Problem(Failure::too_large,
                  "the DEM is larger than " + std::to_string(most_bytes) + " bytes");
  }
  if (bytes == 0) {
    throw Problem(Failure::invalid_request, "the body is empty: send a GeoTIFF");
  }
}

}  // namespace

Answer post_raster(Site& site, const Call& call) {
  RegisterOptions options;
  options.dem.epsg = whole_number(call, "epsg", 0, 1024, 999'999);
  options.dem.vertical_unit = call.parameter("vertical_unit").value_or("");
  read_nodata(call.parameter("nodata").value_or(""), options);
  const std::string& unit = options.dem.vertical_unit;
  if (!unit.empty() && unit != "m" && unit != "ft" && unit != "us-ft") {
    throw Problem(Failure::invalid_parameter,
                  "vertical_unit is '" + unit + "': give m, ft or us-ft");
  }
  const std::string name = call.parameter("name").value_or("");
  refuse_bad_raster_name(name);
  const auto slot = site.registrations.take();  // each reads and writes a whole DEM
  if (!slot) throw Problem(Failure::too_busy, "other DEMs are being registered: try again soon");
  const disk::TemporaryFile upload(site.service.data.uploads() / (random_hex(16) + ".upload"));
  write_body(call, upload.path(), site.limits.raster_bytes);
  const auto raster =
      register_raster(site.service.data, site.service.store, upload.path(), name, options);
  Answer answer = json_answer(document_of(raster, site.url), 201);
  answer.headers.emplace_back("Location", site.url + "/rasters/" + raster.id);
  return answer;
}

Answer get_rasters(Site& site, const Call& call) {
  format(call, {"json"});
  json rasters = json::array();
  for (const auto& raster : site.service.store.rasters()) {
    rasters.push_back(document_of(raster, site.url));
  }
  return json_answer({{"rasters", rasters}});
}

Answer get_raster(Site& site, const Call& call) {
  format(call, {"json"});
  return json_answer(
      document_of(raster_or_problem(site.service.store, call.captured[0]), site.url));
}

Answer patch_raster(Site& site, const Call& call) {
  FaultList faults;
  const auto parsed = parse_json(call.read_body(site.limits.document_bytes));
  std::string name;
  if (parsed) {
    ObjectReader reader(*parsed.value, "", faults);
    name = reader.text("name", 100);
    reader.refuse_unknown();
  }
  auto found = parsed ? faults.take() : parsed.faults;
  if (!found.empty()) {
    throw Problem(Failure::invalid_request, "the body must be {\"name\": \"...\"}", found);
  }
  const auto raster = rename_raster(site.service.store, call.captured[0], name);
  return json_answer(document_of(raster, site.url));
}

Answer delete_raster(Site& site, const Call& call) {
  remove_raster(site.service.data, site.service.store, call.captured[0]);
  Answer answer;
  answer.status = 204;
  return answer;
}

Answer get_hillshade(Site& site, const Call& call) {
  const auto raster = raster_or_problem(site.service.store, call.captured[0]);
  const auto file = hillshade_file(site.service.data, raster);
  const std::string tag = '"' + file.filename().string() + '"';
  if (has_already(call, tag)) return not_modified(tag);
  Answer answer;
  answer.headers.emplace_back("ETag", tag);
  answer.type = "image/png";
  answer.file = file;
  answer.headers.emplace_back("Cache-Control", "max-age=86400");
  if (std::filesystem::exists(file)) return answer;
  const db::Turns::Turn turn(site.hillshades);
  if (std::filesystem::exists(file)) return answer;  // another viewer had the turn before
  profiles::DemOptions options;
  options.missing_m = raster.undeclared_fill_m;
  const auto dem = profiles::Dem::open(site.service.data.root() / raster.file, options);
  profiles::write_hillshade(dem, file);
  return answer;
}

}  // namespace leda::server
