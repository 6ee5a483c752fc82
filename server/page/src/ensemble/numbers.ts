// What an ensemble says, in words and numbers: for the panel, the comparison and the report.

import {status_word} from '../colours';
import type {DistanceRange, DistanceSummary, Ensemble, JobMap, Quantile} from '../types';
import {show, t, word_or} from '../words';

export const distances = ['retrogression', 'runout'] as const;

export function has_ensemble(job: JobMap | null): boolean {
  return job?.request?.inputs?.ensemble !== undefined;
}

/** What the server says in English is said in the reader's language; what it says otherwise, as it is. */
export function condition_words(condition: string): string {
  const known = condition.startsWith('conditional on a slide starting at the section: no yearly probability and no class');
  return known ? t('condition') : condition;
}

export function percent(share: number): string {
  return `${show(100 * share, 1)} %`;
}

/** ">187.0 m" where members were cut short. */
export function distance_words({distance_m, distance_is}: Quantile): string {
  if (distance_m === null) return '–';
  return `${distance_is === 'lower-bound' ? '>' : ''}${show(distance_m)} m`;
}

export function range_words([low, high]: DistanceRange): string {
  return high === null ? t('and_more', {distance: `${show(low)} m`}) : `${show(low)} – ${show(high)} m`;
}

export function summary_rows(ensemble: Ensemble): [string, string][] {
  const {value, low, high} = ensemble.probability_of_sliding;
  const statuses = Object.entries(ensemble.by_status).map(([status, count]) => `${count} ${status_word(status)}`);
  return [
    [t('sliding'), `${percent(value)} (${percent(low)} – ${percent(high)})`],
    [t('members'), `${show(ensemble.members)}: ${statuses.join(', ')}`],
    [t('ended_by'), word_or(`ended_${ensemble.ended_by.replace(/-/g, '_')}`, ensemble.ended_by)],
    [t('half_width'), `± ${percent(ensemble.half_width)} (${t('wanted')} ± ${percent(ensemble.wanted_half_width)})`],
  ];
}

/** Exceedance, distance and interval of each quantile. */
export function quantile_rows(summary: DistanceSummary): [string, string, string][] {
  return summary.quantiles.map((quantile) =>
    [percent(quantile.exceedance), distance_words(quantile), range_words(quantile.by_ranks_m)]);
}

/** A share of the variance of a distance, with its standard error where it has one. */
export interface Decider {
  name: string;
  share: number;
  error: number | null;
}

/** The largest share first; empty where so few members say nothing of it. */
export function deciders(summary: DistanceSummary): Decider[] {
  const inputs = Object.entries(summary.indices).flatMap(([name, index]) =>
    (index ? [{name, share: index.first_order, error: index.standard_error}] : []));
  const chance = summary.chance?.share_of_variance ?? null;
  return [...inputs.sort((a, b) => b.share - a.share),
    ...(chance === null ? [] : [{name: t('chance'), share: chance, error: null}])];
}

export function decider_words({share, error}: Decider): string {
  return error === null ? show(share, 2) : `${show(share, 2)} ± ${show(error, 2)}`;
}

/** What other seeds and finer cells do to the distance, in metres. */
export function check_rows({chance, finer_cell}: DistanceSummary): [string, string][] {
  const rows: [string, string][] = [];
  if (chance) {
    rows.push([t('chance'), t('chance_is', {metres: show(chance.standard_deviation_m), members: chance.members,
      runs: chance.runs})]);
  }
  if (finer_cell) {
    const error = finer_cell.standard_error_m === null ? '' : ` ± ${show(finer_cell.standard_error_m)}`;
    const sign = finer_cell.mean_m > 0 ? '+' : '';
    rows.push([t('finer_cell'), t('finer_cell_is', {metres: `${sign}${show(finer_cell.mean_m)}${error}`,
      pairs: finer_cell.pairs})]);
  }
  return rows;
}

/** Later minus first, m; null where one of the two is a bound or not known. */
export function quantile_difference(from: Quantile, to: Quantile | undefined): number | null {
  if (!to || from.distance_is !== 'measured' || to.distance_is !== 'measured') return null;
  return from.distance_m === null || to.distance_m === null ? null : to.distance_m - from.distance_m;
}
