// Strength over plastic strain of the laws of the published schema, to be drawn as they are typed.
// The one form of all: solver/materials/softening_curve.hpp, which the solver itself steps.

import type {JsonObject} from './types';

interface Curve {
  peak: number;
  floor: number;
  amplitude: number;
  rate: number;
  exp_end: number;
  line_start: number;
  line_end: number;
  last: number;
}

const never = 1e30;

function decay(peak: number, remolded: number, rate: number): Curve {
  const last = Math.min(remolded, peak);
  return {peak, floor: last, amplitude: peak - last, rate, exp_end: never, line_start: last, line_end: 2 * never, last};
}

function urmi(law: JsonObject, peak: number): Curve {
  const last = Math.min(number(law.remolded_strength_kPa), peak);
  const strain = number(law.residual_strain);
  const given = law.residual_strength_kPa === undefined ? 0.095 * peak : number(law.residual_strength_kPa);
  const residual = Math.min(Math.max(given, last), peak);
  const remolded = law.remolded_strain === undefined ? 0.13 * peak * strain : number(law.remolded_strain);
  return {
    peak, floor: residual, amplitude: (peak - residual) * number(law.alpha), rate: number(law.beta),
    exp_end: strain, line_start: residual, line_end: Math.max(strain, remolded), last,
  };
}

function dey(law: JsonObject, peak: number): Curve {
  const residual = Math.min(number(law.remolded_strength_kPa), peak);
  const end = 2 * number(law.strain_95);
  return {
    peak, floor: residual, amplitude: peak - residual, rate: 3 / number(law.strain_95), exp_end: end,
    line_start: residual, line_end: Math.max(number(law.large_strain), end),
    last: Math.min(number(law.large_strain_strength_kPa), residual),
  };
}

function number(value: unknown): number {
  return typeof value === 'number' ? value : NaN;
}

function unscaled(law: JsonObject, peak: number): Curve | null {
  switch (law.law) {
    case 'urmi': return urmi(law, peak);
    case 'dey': return dey(law, peak);
    case 'einav-randolph': return decay(peak, number(law.remolded_strength_kPa), 3 / number(law.strain_95));
    case 'exponential': return decay(peak, number(law.remolded_strength_kPa), number(law.shape_factor));
    case 'linear':
      return {
        peak, floor: peak, amplitude: 0, rate: 0, exp_end: 0, line_start: peak, line_end: number(law.remolded_strain),
        last: Math.min(number(law.remolded_strength_kPa), peak),
      };
    default: return null;
  }
}

/** The law as measured, or scaled to a cell as its regularization says. Null where a number is missing. */
export function softening_curve(law: JsonObject, peak_kPa: number, cell_m?: number): Curve | null {
  const curve = unscaled(law, peak_kPa);
  if (!curve || Object.values(curve).some(Number.isNaN)) return null;
  const kind = law.regularization ?? 'beta';
  if (cell_m === undefined || kind === 'none') return curve;
  const length = kind === 'band' ? number(law.band_m) : cell_m;
  const scale = length / (law.reference_size_m === undefined ? 0.014 : number(law.reference_size_m));
  if (!(scale > 0)) return null;
  if (kind === 'beta' && curve.exp_end > 0) return {...curve, rate: curve.rate * scale};
  return {...curve, rate: curve.rate * scale, exp_end: curve.exp_end / scale, line_end: curve.line_end / scale};
}

/** kPa at a plastic engineering shear strain (fraction). */
export function strength(c: Curve, strain: number): number {
  if (strain <= c.exp_end) return Math.min(c.peak, c.floor + c.amplitude * Math.exp(-c.rate * strain));
  if (strain >= c.line_end) return c.last;
  return c.line_start + ((c.last - c.line_start) * (strain - c.exp_end)) / (c.line_end - c.exp_end);
}

/** A strain by which the curve has said all: its end, or 99 % of an endless decay. */
export function last_strain(c: Curve): number {
  return c.line_end < never ? c.line_end : 5 / c.rate;
}
