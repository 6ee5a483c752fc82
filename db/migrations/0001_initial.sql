-- The first schema of the store. Never edited: a change is a new file with the next number.
-- Times are UTC text, ISO 8601 with Z. Distances are metres and say so; what is on the map is in
-- the units of the DEM's CRS (easting, northing). A REAL that is NULL was not a finite number.

PRAGMA application_id = 0x4C656461;  -- "Leda"

CREATE TABLE rasters (
  sequence      INTEGER PRIMARY KEY,
  id            TEXT NOT NULL UNIQUE,
  name          TEXT NOT NULL UNIQUE,
  file          TEXT NOT NULL,  -- relative to the data folder
  sha256        TEXT NOT NULL,
  epsg          INTEGER NOT NULL,
  cell_x        REAL,           -- units of the CRS
  cell_y        REAL,
  width_cells   INTEGER NOT NULL,
  height_cells  INTEGER NOT NULL,
  west REAL, south REAL, east REAL, north REAL,
  vertical_unit TEXT NOT NULL,
  created       TEXT NOT NULL
) STRICT;

CREATE TABLE jobs (
  sequence        INTEGER PRIMARY KEY AUTOINCREMENT,  -- the order jobs were accepted in
  id              TEXT NOT NULL UNIQUE,
  process         TEXT NOT NULL,
  name            TEXT NOT NULL,
  state           TEXT NOT NULL
                  CHECK (state IN ('accepted', 'running', 'successful', 'failed', 'dismissed')),
  message         TEXT NOT NULL,
  progress        INTEGER NOT NULL CHECK (progress BETWEEN 0 AND 100),
  request         TEXT NOT NULL,  -- the execute request as sent
  idempotency_key TEXT UNIQUE,
  raster_id       TEXT REFERENCES rasters (id),
  created         TEXT NOT NULL,
  started         TEXT,
  finished        TEXT,
  updated         TEXT NOT NULL
) STRICT;
CREATE INDEX jobs_by_state ON jobs (state);

CREATE TABLE sections (
  id            INTEGER PRIMARY KEY AUTOINCREMENT,  -- never given twice: a late result finds no stranger
  job_id        TEXT NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
  ordinal       INTEGER NOT NULL,
  name          TEXT NOT NULL,
  line          INTEGER NOT NULL,  -- sections along one line are neighbours; -1: a named line
  position_m    REAL,              -- along that line
  trace         TEXT NOT NULL,     -- JSON [[easting, northing], ...]
  ground        TEXT NOT NULL,     -- JSON [[x_m, z_m], ...]
  crest_x_m REAL, crest_z_m REAL,
  toe_x_m REAL, toe_z_m REAL,
  state         TEXT NOT NULL
                CHECK (state IN ('waiting', 'running', 'finished', 'left_out', 'stable', 'failed',
                                 'dismissed')),
  reason        TEXT NOT NULL,
  screening     TEXT,              -- JSON; NULL: not screened
  warnings      TEXT NOT NULL,     -- JSON ["...", ...]
  latest_run_id TEXT REFERENCES runs (id) DEFERRABLE INITIALLY DEFERRED,
  UNIQUE (job_id, name),
  UNIQUE (job_id, ordinal)
) STRICT;

-- Every try is kept.
CREATE TABLE runs (
  id         TEXT PRIMARY KEY,     -- also its folder under runs/
  section_id INTEGER NOT NULL REFERENCES sections (id) ON DELETE CASCADE,
  attempt    INTEGER NOT NULL,     -- 1, 2, ...
  started    TEXT NOT NULL,
  finished   TEXT,
  outcome    TEXT CHECK (outcome IN ('result', 'unstable', 'failed', 'interrupted', 'dismissed',
                                     'superseded')),  -- NULL: under way
  reason     TEXT NOT NULL,
  UNIQUE (section_id, attempt)
) STRICT;

CREATE TABLE results (
  run_id               TEXT PRIMARY KEY REFERENCES runs (id) ON DELETE CASCADE,
  section_id           INTEGER NOT NULL REFERENCES sections (id) ON DELETE CASCADE,
  status               TEXT NOT NULL
                       CHECK (status IN ('stable', 'at-rest', 'time-limit', 'left-domain',
                                         'unstable')),
  reason               TEXT NOT NULL,
  retrogression_m      REAL,       -- crest to crest
  runout_m             REAL,       -- from the initial toe
  runout_from_crest_m  REAL,
  crest_x_m REAL, crest_z_m REAL,  -- initial
  toe_x_m REAL, toe_z_m REAL,      -- initial
  backscarp_x_m REAL, backscarp_z_m REAL,
  front_x_m REAL, front_z_m REAL,
  trigger_used         TEXT NOT NULL,
  slides               INTEGER NOT NULL,
  simulated_s          REAL,
  run_time_s           REAL,
  steps                INTEGER NOT NULL,
  particles            INTEGER NOT NULL,
  ns_per_particle_step REAL,
  mass_error REAL, momentum_error REAL, energy_error REAL,  -- relative
  numerical_dissipation REAL,      -- share of the released energy
  profile_after        TEXT NOT NULL,  -- JSON [[x_m, z_m], ...]
  warnings             TEXT NOT NULL,  -- JSON ["...", ...]
  case_sha256          TEXT NOT NULL,
  version              TEXT NOT NULL,
  taken_in             TEXT NOT NULL,
  document             TEXT NOT NULL   -- result.json as the worker wrote it
) STRICT;
-- The rule "one result a section" held by the file itself; an unstable run may be tried again.
CREATE UNIQUE INDEX one_usable_result ON results (section_id) WHERE status <> 'unstable';

-- A result back on the map.
CREATE TABLE placements (
  run_id          TEXT PRIMARY KEY REFERENCES results (run_id) ON DELETE CASCADE,
  known           INTEGER NOT NULL,
  moved           INTEGER NOT NULL,
  backscarp_easting REAL, backscarp_northing REAL,
  crest_easting REAL, crest_northing REAL,
  toe_easting REAL, toe_northing REAL,
  front_easting REAL, front_northing REAL,
  retrogression_m REAL,
  runout_m        REAL,
  warnings        TEXT NOT NULL,   -- JSON ["...", ...]
  made_by         TEXT NOT NULL    -- hash of case and program
) STRICT;

CREATE TABLE zones (
  id                 INTEGER PRIMARY KEY AUTOINCREMENT,
  job_id             TEXT NOT NULL REFERENCES jobs (id) ON DELETE CASCADE,
  ordinal            INTEGER NOT NULL,
  kind               TEXT NOT NULL CHECK (kind IN ('release', 'runout')),
  area               TEXT NOT NULL,  -- JSON coordinates of a GeoJSON MultiPolygon, in the DEM's CRS
  largest_distance_m REAL,
  mean_distance_m    REAL,
  warnings           TEXT NOT NULL,  -- JSON ["...", ...]
  made_by            TEXT NOT NULL,
  UNIQUE (job_id, ordinal)
) STRICT;

-- Whose results made a zone.
CREATE TABLE zone_sections (
  zone_id INTEGER NOT NULL REFERENCES zones (id) ON DELETE CASCADE,
  ordinal INTEGER NOT NULL,
  job_id  TEXT NOT NULL,
  section TEXT NOT NULL,
  PRIMARY KEY (zone_id, ordinal),
  FOREIGN KEY (job_id, section) REFERENCES sections (job_id, name) ON DELETE CASCADE
) STRICT;
CREATE INDEX zone_sections_by_section ON zone_sections (job_id, section);

-- What is asked most, for whoever opens the file with sqlite3.
CREATE VIEW section_results AS
SELECT jobs.id AS job, jobs.name AS region, rasters.name AS dem, rasters.sha256 AS dem_sha256,
       sections.name AS section, sections.state, sections.reason, results.status,
       results.retrogression_m, results.runout_m, results.runout_from_crest_m,
       results.trigger_used, results.slides, results.run_time_s, results.warnings,
       results.case_sha256, results.version, results.run_id
FROM sections
JOIN jobs ON jobs.id = sections.job_id
LEFT JOIN rasters ON rasters.id = jobs.raster_id
LEFT JOIN results ON results.run_id = sections.latest_run_id
ORDER BY jobs.sequence, sections.ordinal;
