-- Whether a distance is the end of a slide or only as far as its run followed it.
ALTER TABLE results ADD COLUMN retrogression_is TEXT NOT NULL DEFAULT 'measured'
  CHECK (retrogression_is IN ('measured', 'lower-bound'));
ALTER TABLE results ADD COLUMN runout_is TEXT NOT NULL DEFAULT 'measured'
  CHECK (runout_is IN ('measured', 'lower-bound'));
ALTER TABLE zones ADD COLUMN distance_is TEXT NOT NULL DEFAULT 'measured'
  CHECK (distance_is IN ('measured', 'lower-bound'));

-- What results of before did not say, their status and their warnings do.
UPDATE results SET retrogression_is = 'lower-bound'
  WHERE status NOT IN ('stable', 'at-rest') OR warnings LIKE '%retrogression is a lower bound%';
UPDATE results SET runout_is = 'lower-bound'
  WHERE status NOT IN ('stable', 'at-rest') OR warnings LIKE '%runout is a lower bound%';
UPDATE zones SET distance_is = 'lower-bound' WHERE EXISTS (
  SELECT 1 FROM zone_sections
  JOIN sections ON sections.job_id = zone_sections.job_id
   AND sections.name = zone_sections.section
  JOIN results ON results.run_id = sections.latest_run_id
  WHERE zone_sections.zone_id = zones.id
    AND 'lower-bound' = CASE zones.kind WHEN 'release' THEN results.retrogression_is
                                        ELSE results.runout_is END);
