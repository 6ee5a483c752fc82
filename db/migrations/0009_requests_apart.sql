-- Requests apart: one may be 16 MiB long, and whoever reads or writes a column of a row that comes
-- after it, be it only the progress of a job, walks all of its pages.
CREATE TABLE requests (
  sequence INTEGER PRIMARY KEY REFERENCES jobs (sequence) ON DELETE CASCADE,
  request  TEXT NOT NULL  -- the execute request as sent
) STRICT;
INSERT INTO requests SELECT sequence, request FROM jobs;
ALTER TABLE jobs DROP COLUMN request;
