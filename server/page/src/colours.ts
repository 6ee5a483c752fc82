// Colours of states and numbers, told apart by colour-blind eyes too: Okabe and Ito (2008) for states,
// steps of viridis (van der Walt and Smith 2015) for numbers.

import type {JobMap} from './types';
import {type Word, show, t, word_or} from './words';

export type ColourBy = 'status' | 'retrogression' | 'runout' | 'cost';

export interface Entry {
  colour: string;
  label: string;
  dashed?: boolean;
}

const of_status: Record<string, string> = {
  'at-rest': '#d55e00', stable: '#009e73', 'time-limit': '#cc79a7', 'left-domain': '#e69f00', unstable: '#000000',
  failed: '#000000', left_out: '#8a8a8a', dismissed: '#8a8a8a', waiting: '#f0e442', running: '#56b4e9',
};
const no_value = '#8a8a8a';
export const steps_of_numbers = ['#fde725', '#90d743', '#35b779', '#21918c', '#31688e', '#440154'];
/** of materials and particles of a kind */
export const kinds = ['#b38867', '#7fa5b8', '#d9bf77', '#8f9f6a', '#a07aa0', '#6f6f6f', '#c98b8b', '#5d8aa8'];

/** Upper ends of the classes of probability that have a colour of their own; beyond the last: the fifth. */
const probability_classes = [0.05, 0.2, 0.5, 0.8];
/** ColorBrewer's YlOrRd and PuBu, as the exports to QGIS have them */
const of_probability = {
  release: ['#ffffb2', '#fecc5c', '#fd8d3c', '#f03b20', '#bd0026'],
  runout: ['#f1eef6', '#bdc9e1', '#74a9cf', '#2b8cbe', '#045a8d'],
};

export function probability_colour(kind: 'release' | 'runout', probability: number): string {
  const at = probability_classes.findIndex((most) => probability <= most);
  return of_probability[kind].at(at)!;
}

function normal(status: string): string {
  return status === 'left-out' ? 'left_out' : status;
}

export function status_word(status: string): string {
  return word_or(`state_${normal(status).replace(/-/g, '_')}`, status);
}

/** Rounded limits, `count` of them apart, from 0 to at least `most`. */
export function limits_of(most: number, count: number): number[] {
  if (!(most > 0)) return [];
  const raw = most / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map((n) => n * power).find((n) => n >= raw * 0.999)!;
  return Array.from({length: count}, (_, i) => step * (i + 1));
}

export function step_colour(value: number | null, limits: readonly number[]): string {
  if (value === null || limits.length === 0) return no_value;
  const at = limits.findIndex((limit) => value <= limit);
  return steps_of_numbers[at < 0 ? limits.length - 1 : at]!;
}

function column(map: JobMap, by: ColourBy): (number | null)[] {
  if (by === 'retrogression') return map.sections.retrogression_m;
  return by === 'runout' ? map.sections.runout_m : map.sections.run_time_s;
}

function is_bound(map: JobMap, by: ColourBy, i: number): boolean {
  if (by === 'retrogression') return map.sections.retrogression_is[i] === 'lower-bound';
  return by === 'runout' && map.sections.runout_is[i] === 'lower-bound';
}

const titles: Record<ColourBy, Word> = {
  status: 'status', retrogression: 'retrogression', runout: 'runout', cost: 'run_time',
};

/** The colour of every section of a job, and the legend of them. */
export function colour_sections(map: JobMap, by: ColourBy): {entries: Entry[]; of: Entry[]; title: string} {
  if (by === 'status') {
    const of = map.sections.status.map((status) =>
      ({colour: of_status[normal(status)] ?? no_value, label: status_word(status)}));
    const entries = [...new Map(of.map((entry) => [entry.label, entry])).values()];
    return {entries, of, title: t('status')};
  }
  const values = column(map, by);
  const most = values.reduce<number>((a, b) => Math.max(a, b ?? 0), 0);
  const limits = limits_of(most, steps_of_numbers.length);
  const of = values.map((value, i) =>
    ({colour: step_colour(value, limits), label: '', dashed: is_bound(map, by, i)}));
  const unit = by === 'cost' ? 's' : 'm';
  const entries: Entry[] = limits.map((limit, i) =>
    ({colour: steps_of_numbers[i]!, label: `${show(i ? limits[i - 1]! : 0)} – ${show(limit)} ${unit}`}));
  if (values.includes(null)) entries.push({colour: no_value, label: t('no_value')});
  if (of.some((entry) => entry.dashed)) entries.push({colour: '#222222', label: t('lower_bound'), dashed: true});
  return {entries, of, title: t(titles[by])};
}
