-- Members of an ensemble: runs of a section with drawn inputs. A member has a row like a section,
-- so that it is run, tried again, kept and removed like one; its ground is that of its section.
ALTER TABLE sections ADD COLUMN member_of INTEGER;    -- ordinal of its section; NULL: a section
ALTER TABLE sections ADD COLUMN member INTEGER;       -- number of the draw, from 0
ALTER TABLE sections ADD COLUMN member_repeat INTEGER;  -- the same draw with another seed; 0: itself
ALTER TABLE sections ADD COLUMN member_finer INTEGER;   -- the same draw with finer cells
CREATE INDEX members_of_a_section ON sections (job_id, member_of, ordinal)
  WHERE member_of IS NOT NULL;
-- Whether a row is a member, without reading the row.
DROP INDEX sections_in_order;
CREATE INDEX sections_in_order ON sections (job_id, id, state, member_of);

-- A zone that holds with a probability: its distances are exceeded with `exceedance`.
ALTER TABLE zones ADD COLUMN exceedance REAL;   -- NULL: of the sections' own runs
ALTER TABLE zones ADD COLUMN members INTEGER;   -- fewest of one of its sections

DROP VIEW section_results;
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
WHERE sections.member_of IS NULL
ORDER BY jobs.sequence, sections.ordinal;

CREATE VIEW member_results AS
SELECT sections.job_id AS job, whole.name AS section, sections.member, sections.member_repeat,
       sections.member_finer, sections.state, results.status, results.retrogression_m,
       results.retrogression_is, results.runout_m, results.runout_is, results.run_time_s,
       results.case_sha256, results.version, results.run_id
FROM sections
JOIN sections AS whole
  ON whole.job_id = sections.job_id AND whole.ordinal = sections.member_of
LEFT JOIN results ON results.run_id = sections.latest_run_id
WHERE sections.member_of IS NOT NULL
ORDER BY sections.job_id, sections.member_of, sections.member, sections.member_repeat;
