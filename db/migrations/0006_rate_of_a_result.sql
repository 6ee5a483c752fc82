-- When strength began to depend on the rate of shear, s; null where it never did.
ALTER TABLE results ADD COLUMN rate_from_s REAL;
