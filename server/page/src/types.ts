// Documents of the server, as far as the page reads them.

export type XY = [number, number];

export interface Raster {
  id: string;
  name: string;
  crs: string;
  proj4: string;
  size: [number, number];
  cell_on_ground_m: XY | null;
  bbox: [number, number, number, number];
  vertical_unit: string;
  lowest_m: number | null;
  highest_m: number | null;
  share_without_data: number | null;
  undeclared_fill_m: number | null;
  warnings: string[];
  sha256: string;
  created: string;
}

export interface Job {
  jobID: string;
  processID: string;
  name?: string;
  status: 'accepted' | 'running' | 'successful' | 'failed' | 'dismissed';
  message: string;
  progress: number;
  created: string;
  updated: string;
}

export interface Zone {
  sections: string[];
  largest_distance_m: number;
  mean_distance_m: number;
  distance_is: string;
  warnings: string[];
  polygons: XY[][][];
}

/** An area of the ground that some share of the members reaches. */
export interface ProbabilityZone extends Zone {
  kind: 'release' | 'runout';
  exceedance: number;
  members: number;
}

export interface JobMap {
  job: string;
  name: string;
  processID: string;
  status: Job['status'];
  message: string;
  dem: string;
  crs: string;
  request: {inputs?: Record<string, unknown>} | null;
  sections: {
    name: string[];
    line: (number | null)[];
    order_m: (number | null)[];
    trace: XY[][];
    state: string[];
    status: string[];
    retrogression_m: (number | null)[];
    retrogression_is: (string | null)[];
    runout_m: (number | null)[];
    runout_is: (string | null)[];
    run_time_s: (number | null)[];
    warnings: number[];
  };
  release_zones: Zone[];
  runout_zones: Zone[];
  probability_zones: ProbabilityZone[];
}

/** A section as the layout would cut it. */
export interface LaidSection {
  name: string;
  line: number | null;
  trace: XY[];
  profile?: XY[];
  crest_m?: XY;
  toe_m?: XY;
  reason?: string;
  warnings?: string[];
}

export interface Result {
  backscarp_m?: XY | null;
  front_m?: XY | null;
  balances?: Record<string, number>;
  trigger_used?: string;
  [key: string]: unknown;
}

export interface SectionDetail {
  name: string;
  state: string;
  status: string;
  reason: string;
  run: string;
  attempts: number;
  trace: XY[];
  profile_before: XY[];
  profile_after: XY[] | null;
  crest_m: XY | null;
  toe_m: XY | null;
  crest_to_crest_retrogression_m: number | null;
  retrogression_is: string | null;
  runout_m: number | null;
  runout_is: string | null;
  runout_from_crest_m: number | null;
  slides: number | null;
  simulated_s: number | null;
  run_time_s: number | null;
  particles: number | null;
  ns_per_particle_step: number | null;
  case_sha256: string | null;
  dem_sha256: string | null;
  version: string | null;
  screening: Record<string, unknown> | null;
  result: Result | null;
  warnings: string[];
  log: string;
}

/** From and to, m; null: beyond any distance. */
export type DistanceRange = [number, number | null];

export interface Quantile {
  exceedance: number;
  distance_m: number | null;
  distance_is: 'measured' | 'lower-bound' | 'unknown';
  by_ranks_m: DistanceRange;
}

export interface ExceedanceCurve {
  /** distance, m; the probability that it is exceeded; the ends of the interval of that */
  points: [number, number, number, number][];
  half_width: number;
  censored_beyond_m: number | null;
}

/** What the members of a section say of a distance. */
export interface DistanceSummary {
  quantiles: Quantile[];
  curve: ExceedanceCurve;
  indices: Record<string, {first_order: number; standard_error: number} | null>;
  chance: {members: number; runs: number; standard_deviation_m: number; share_of_variance: number | null} | null;
  finer_cell: {pairs: number; mean_m: number; standard_error_m: number | null} | null;
}

export interface Ensemble {
  section: string;
  condition: string;
  members: number;
  by_status: Record<string, number>;
  ended_by: string;
  half_width: number;
  wanted_half_width: number;
  confidence: number;
  probability_of_sliding: {value: number; low: number; high: number};
  retrogression: DistanceSummary;
  runout: DistanceSummary;
  warnings: string[];
}

export interface StudySetting {
  cell_m: number;
  particles_per_cell: number;
  time_step_factor: number;
  crest_to_crest_retrogression_m: {mean: number} | null;
  runout_m: {mean: number} | null;
  /** of the larger of the two distances' errors, shares of 1 */
  error: {both: {of_runs: {mean: number} | null; mean_within: boolean}};
  cost_s: number | null;
  is_reference: boolean;
  not_a_choice: string;
}

export interface Study {
  outcome: string[];
  warnings: string[];
  settings: StudySetting[];
  fastest_within_wanted_error: {
    both: {by_mean: {cell_m: number; particles_per_cell: number; time_step_factor: number} | null} | null;
  };
}

export interface DryRun {
  sections: {name: string; state: string; reason: string; particles: number | null; warnings: string[]}[];
  estimate: {
    runs: number;
    left_out: number;
    stable: number;
    particles: number;
    most_particles_of_a_run: number;
    core_hours_at_least: number;
    core_hours: number;
    core_hours_at_most: number;
    disk_bytes: number;
    based_on: string;
  };
}

export type Json = null | boolean | number | string | Json[] | {[key: string]: Json | undefined};
export type JsonObject = {[key: string]: Json | undefined};
