-- What computed a result. NULL in results that were computed before they named it.
ALTER TABLE results ADD COLUMN precision TEXT CHECK (precision IN ('single', 'double'));
ALTER TABLE results ADD COLUMN instructions TEXT;        -- of the processor: 'avx2', 'avx3', 'sse4'
ALTER TABLE results ADD COLUMN time_step_factor REAL;    -- of h / c_p, as used
ALTER TABLE results ADD COLUMN averaged_dilation INTEGER;
