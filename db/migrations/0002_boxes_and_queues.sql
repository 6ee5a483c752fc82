-- Where features lie, in longitude and latitude (CRS84): a page of features inside a box is found
-- here, without reading the geometry of all others. Tables of their own, because a column behind
-- the long texts of a row is slow to reach.
CREATE TABLE section_boxes (
  section_id INTEGER PRIMARY KEY REFERENCES sections (id) ON DELETE CASCADE,
  west REAL NOT NULL, south REAL NOT NULL, east REAL NOT NULL, north REAL NOT NULL
) STRICT;
CREATE TABLE zone_boxes (
  zone_id INTEGER PRIMARY KEY REFERENCES zones (id) ON DELETE CASCADE,
  west REAL NOT NULL, south REAL NOT NULL, east REAL NOT NULL, north REAL NOT NULL
) STRICT;
CREATE INDEX zones_by_kind ON zones (kind, job_id);

-- What waits and what runs, counted at every look at the metrics.
CREATE INDEX sections_in_line ON sections (state) WHERE state IN ('waiting', 'running');
CREATE INDEX jobs_by_end ON jobs (finished);

-- Without these, removing a job reads all results and all sections once for each of its sections.
CREATE INDEX results_by_section ON results (section_id);
CREATE INDEX sections_by_latest_run ON sections (latest_run_id);
