// Results: what a run said about its section, and where that lies on the map.

#include "db/connection.hpp"
#include "db/json_text.hpp"
#include "db/section_row.hpp"
#include "db/store.hpp"

namespace leda::db {

const std::string& result_columns() {
  static const std::string columns =
      "results.status, results.reason, results.retrogression_m, results.runout_m, "
      "results.runout_from_crest_m, results.retrogression_is, results.runout_is, "
      "results.crest_x_m, results.crest_z_m, results.toe_x_m, "
      "results.toe_z_m, results.backscarp_x_m, results.backscarp_z_m, results.front_x_m, "
      "results.front_z_m, results.trigger_used, results.slides, results.rate_from_s, "
      "results.simulated_s, "
      "results.run_time_s, results.steps, results.particles, results.ns_per_particle_step, "
      "results.mass_error, results.momentum_error, results.energy_error, "
      "results.numerical_dissipation, results.profile_after, results.warnings, "
      "results.case_sha256, results.version, results.precision, results.instructions, "
      "results.time_step_factor, results.averaged_dilation, "
      "placements.known, placements.moved, "
      "placements.backscarp_easting, placements.backscarp_northing, "
      "placements.crest_easting, placements.crest_northing, "
      "placements.toe_easting, placements.toe_northing, "
      "placements.front_easting, placements.front_northing, "
      "placements.retrogression_m, placements.runout_m, placements.warnings, placements.made_by";
  return columns;
}

namespace {

std::optional<Engine> engine_from(Query& row) {
  const auto precision = precision_from(row.text());
  Engine engine{.precision = precision.value_or(Precision::double_precision),
                .instructions = row.text(),
                .time_step_factor = row.real(),
                .averaged_dilation = row.integer() != 0};
  return precision ? std::optional(std::move(engine)) : std::nullopt;
}

SectionResult result_from(Query& row) {
  return SectionResult{.status = run_status_from(row.text()).value(),
                       .reason = row.text(),
                       .crest_to_crest_retrogression_m = row.real(),
                       .runout_m = row.real(),
                       .runout_from_crest_m = row.real(),
                       .retrogression_is = bound_from(row.text()).value(),
                       .runout_is = bound_from(row.text()).value(),
                       .crest = {row.real(), row.real()},
                       .toe = {row.real(), row.real()},
                       .backscarp = {row.real(), row.real()},
                       .front = {row.real(), row.real()},
                       .trigger_used = row.text(),
                       .slides = row.small_integer(),
                       .rate_from_s = row.optional_real(),
                       .simulated_s = row.real(),
                       .run_time_s = row.real(),
                       .steps = row.integer(),
                       .particles = row.integer(),
                       .ns_per_particle_step = row.real(),
                       .balances = {row.real(), row.real(), row.real()},
                       .numerical_dissipation = row.real(),
                       .profile_after = polyline_from_json(row.text()),
                       .warnings = words_from_json(row.text()),
                       .case_sha256 = row.text(),
                       .version = row.text(),
                       .engine = engine_from(row)};
}

PlacedResult placed_from(Query& row, const SectionRecord& section) {
  return PlacedResult{.section = section.name,
                      .line = section.line,
                      .order = section.order,
                      .known = row.integer() != 0,
                      .moved = row.integer() != 0,
                      .backscarp = {row.real(), row.real()},
                      .crest = {row.real(), row.real()},
                      .toe = {row.real(), row.real()},
                      .front = {row.real(), row.real()},
                      .retrogression_m = row.real(),
                      .runout_m = row.real(),
                      .warnings = words_from_json(row.text()),
                      .made_by = row.text()};
}

void insert_engine(Database& database, const std::string& run, const Engine& e) {
  Query(database,
        "UPDATE results SET precision = ?2, instructions = ?3, time_step_factor = ?4, "
        "averaged_dilation = ?5 WHERE run_id = ?1")
      .with(run, to_string(e.precision), e.instructions, e.time_step_factor, e.averaged_dilation)
      .run();
}

void insert_result(Database& database, std::int64_t section, const std::string& run,
                   const SectionResult& r, const std::string& document) {
  Query(database,
        "INSERT INTO results (run_id, section_id, status, reason, retrogression_m, runout_m, "
        "runout_from_crest_m, retrogression_is, runout_is, crest_x_m, crest_z_m, toe_x_m, toe_z_m, "
        "backscarp_x_m, "
        "backscarp_z_m, front_x_m, front_z_m, trigger_used, slides, rate_from_s, simulated_s, "
        "run_time_s, "
        "steps, particles, ns_per_particle_step, mass_error, momentum_error, energy_error, "
        "numerical_dissipation, profile_after, warnings, case_sha256, version, taken_in, "
        "document) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
        "?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .with(run, section, to_string(r.status), r.reason, r.crest_to_crest_retrogression_m,
            r.runout_m, r.runout_from_crest_m, to_string(r.retrogression_is),
            to_string(r.runout_is), r.crest.x, r.crest.z, r.toe.x, r.toe.z, r.backscarp.x,
            r.backscarp.z, r.front.x, r.front.z, r.trigger_used, r.slides, r.rate_from_s,
            r.simulated_s, r.run_time_s, r.steps, r.particles, r.ns_per_particle_step,
            r.balances.mass, r.balances.momentum, r.balances.energy, r.numerical_dissipation,
            to_json(r.profile_after), to_json(r.warnings), r.case_sha256, r.version, utc_now(),
            document)
      .run();
  if (r.engine) insert_engine(database, run, *r.engine);
}

void insert_placement(Database& database, const std::string& run, const PlacedResult& p) {
  Query(database,
        "INSERT INTO placements (run_id, known, moved, backscarp_easting, backscarp_northing, "
        "crest_easting, crest_northing, toe_easting, toe_northing, front_easting, "
        "front_northing, retrogression_m, runout_m, warnings, made_by) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .with(run, p.known, p.moved, p.backscarp.x, p.backscarp.y, p.crest.x, p.crest.y, p.toe.x,
            p.toe.y, p.front.x, p.front.y, p.retrogression_m, p.runout_m, to_json(p.warnings),
            p.made_by)
      .run();
}

bool is_taken_in(Database& database, std::int64_t section, const std::string& run) {
  Query row(database,
            "SELECT section_id, EXISTS (SELECT 1 FROM results WHERE run_id = ?1) "
            "FROM runs WHERE id = ?1");
  if (!row.with(run).next() || row.integer() != section)
    throw StoreError("run \"" + run + "\" is not a run of section " + std::to_string(section));
  return row.integer() != 0;
}

// The run with the result is the section's latest from now on; another one under way lost the race.
void book_run(Database& database, std::int64_t section, const std::string& run,
              const SectionResult& result) {
  const bool usable = result.status != RunStatus::unstable;
  const std::string now = utc_now();
  Query(database, "UPDATE runs SET finished = ?2, outcome = ?3, reason = ?4 WHERE id = ?1")
      .with(run, now, usable ? "result" : "unstable", result.reason)
      .run();
  close_run(database, section, "superseded", "run " + run + " gave its result first");
  const SectionState state = usable ? SectionState::finished : SectionState::failed;
  Query(database, "UPDATE sections SET state = ?2, reason = ?3, latest_run_id = ?4 WHERE id = ?1")
      .with(section, to_string(state), result.reason, run)
      .run();
}

}  // namespace

void read_result(Query& row, SectionRecord& section) {
  if (row.is_null()) return;
  section.result = result_from(row);
  section.placed = placed_from(row, section);
  section.placed->retrogression_is = section.result->retrogression_is;
  section.placed->runout_is = section.result->runout_is;
}

bool Store::take_in(std::int64_t section, const std::string& run, const SectionResult& result,
                    const PlacedResult& placed, const std::string& result_json) {
  if (result.status == RunStatus::interrupted)
    throw StoreError("run \"" + run + "\" was interrupted: there is no result to take in");
  return connection_->write([&](Database& database) {
    const SectionState state = state_of_section(database, section);
    if (is_taken_in(database, section, run)) return false;
    if (state == SectionState::finished || state == SectionState::dismissed) return false;
    insert_result(database, section, run, result, result_json);
    insert_placement(database, run, placed);
    book_run(database, section, run, result);
    return true;
  });
}

std::optional<std::string> Store::result_document(std::int64_t section) const {
  return connection_->read([&](Database& database) -> std::optional<std::string> {
    Query row(database,
              "SELECT document FROM results JOIN sections "
              "ON sections.latest_run_id = results.run_id WHERE sections.id = ?");
    if (!row.with(section).next()) return std::nullopt;
    return row.text();
  });
}

}  // namespace leda::db
