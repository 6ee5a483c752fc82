// Exceedance curves as lines to draw: step functions, with a corner at each end of a step.

import type {ExceedanceCurve} from '../types';

/** Lines over the same distances; null where a line does not run. */
export interface CurveLines {
  measured: (number | null)[];
  /** from where members were cut short and may reach further than known */
  cut_short: (number | null)[];
  low: number[];
  high: number[];
}

type Point = ExceedanceCurve['points'][number];

/** The point whose step a distance lies on; at a point itself the step that begins there, or where
 *  `before`, the one that ends there. */
function step_at(points: readonly Point[], distance_m: number, before: boolean): Point {
  let found = points[0]!;
  for (const point of points) {
    if (before ? point[0] >= distance_m : point[0] > distance_m) break;
    found = point;
  }
  return found;
}

/** The farthest point of all curves, and somewhat more. */
export function farthest_of(curves: readonly ExceedanceCurve[]): number {
  return 1.05 * Math.max(1, ...curves.map(({points}) => points[points.length - 1]![0]));
}

/** @return distances, each twice where steps may end, and the lines of every curve over them */
export function curve_lines(curves: readonly ExceedanceCurve[]): {distances_m: number[]; lines: CurveLines[]} {
  const ends = [...new Set(curves.flatMap(({points}) => points.map(([distance]) => distance)))].sort((a, b) => a - b);
  const corners = [...ends.flatMap((at) => [{at, before: true}, {at, before: false}]),
    {at: farthest_of(curves), before: false}];
  const lines = curves.map(({points, censored_beyond_m}) => {
    const steps = corners.map(({at, before}) => step_at(points, at, before));
    const from = censored_beyond_m ?? Infinity;
    return {
      measured: corners.map(({at, before}, i) => (at < from || (at === from && before) ? steps[i]![1] : null)),
      cut_short: corners.map(({at}, i) => (at >= from ? steps[i]![1] : null)),
      low: steps.map((step) => step[2]), high: steps.map((step) => step[3]),
    };
  });
  return {distances_m: corners.map(({at}) => at), lines};
}
