-- What registration found in the cells of a DEM. NULL in rows of before.
ALTER TABLE rasters ADD COLUMN lowest_m REAL;
ALTER TABLE rasters ADD COLUMN highest_m REAL;
ALTER TABLE rasters ADD COLUMN share_without_data REAL;
ALTER TABLE rasters ADD COLUMN cell_ground_x_m REAL;   -- a cell on the ground, at the DEM's middle
ALTER TABLE rasters ADD COLUMN cell_ground_y_m REAL;
ALTER TABLE rasters ADD COLUMN undeclared_fill_m REAL; -- cells of this value count as missing
ALTER TABLE rasters ADD COLUMN warnings TEXT NOT NULL DEFAULT '[]';  -- JSON ["...", ...]
-- A DEM whose file is gone; the row stays for the jobs that stand on it.
ALTER TABLE rasters ADD COLUMN removed TEXT;
