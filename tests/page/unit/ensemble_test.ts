import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {probability_colour} from '../../../server/page/src/colours';
import {curve_lines, farthest_of} from '../../../server/page/src/ensemble/curves';
import {check_rows, condition_words, decider_words, deciders, distance_words, has_ensemble, quantile_difference,
  range_words, summary_rows} from '../../../server/page/src/ensemble/numbers';
import type {DistanceSummary, Ensemble, ExceedanceCurve, JobMap, Quantile} from '../../../server/page/src/types';

const curve: ExceedanceCurve = {
  points: [[0, 0.8, 0.6, 0.9], [50, 0.4, 0.2, 0.5], [100, 0, 0, 0.3]], half_width: 0.15, censored_beyond_m: 100,
};

const quantile = (distance_m: number | null, distance_is: Quantile['distance_is']): Quantile =>
  ({exceedance: 0.05, distance_m, distance_is, by_ranks_m: [10, null]});

test('a curve is a step line with a corner at each end of a step', () => {
  const {distances_m, lines: [line]} = curve_lines([curve]);
  assert.deepEqual(distances_m, [0, 0, 50, 50, 100, 100, 105]);
  assert.deepEqual(line!.measured, [0.8, 0.8, 0.8, 0.4, 0.4, null, null]);
  assert.deepEqual(line!.high, [0.9, 0.9, 0.9, 0.5, 0.5, 0.3, 0.3]);
  assert.deepEqual(line!.low, [0.6, 0.6, 0.6, 0.2, 0.2, 0, 0]);
});

test('where members were cut short the curve is drawn apart', () => {
  const {lines: [line]} = curve_lines([curve]);
  assert.deepEqual(line!.cut_short, [null, null, null, null, 0.4, 0, 0]);
  const {lines: [whole]} = curve_lines([{...curve, censored_beyond_m: null}]);
  assert.ok(whole!.measured.every((one) => one !== null));
  assert.ok(whole!.cut_short.every((one) => one === null));
});

test('two curves are drawn over the same distances', () => {
  const other: ExceedanceCurve = {points: [[0, 1, 1, 1], [200, 0, 0, 0]], half_width: 0, censored_beyond_m: null};
  const {distances_m, lines} = curve_lines([curve, other]);
  assert.equal(distances_m.at(-1), farthest_of([curve, other]));
  assert.equal(farthest_of([curve, other]), 210);
  assert.deepEqual(lines[1]!.measured, [1, 1, 1, 1, 1, 1, 1, 0, 0]);
  assert.deepEqual(lines.map((line) => line.low.length), [9, 9]);
});

test('a distance that may be passed is written so, an unknown one is none', () => {
  assert.equal(distance_words(quantile(187.04, 'lower-bound')), '>187 m');
  assert.equal(distance_words(quantile(12.34, 'measured')), '12.3 m');
  assert.equal(distance_words(quantile(null, 'unknown')), '–');
  assert.equal(range_words([3, 4.25]), '3 – 4.3 m');
  assert.equal(range_words([3, null]), '3 m and more');
});

test('what decides comes with the largest share first, chance last', () => {
  const summary = {
    indices: {a: {first_order: 0.2, standard_error: 0.05}, b: null, c: {first_order: 0.7, standard_error: 0.1}},
    chance: {members: 2, runs: 4, standard_deviation_m: 1.5, share_of_variance: 0.9},
    finer_cell: {pairs: 2, mean_m: 1.2, standard_error_m: 0.4},
  } as unknown as DistanceSummary;
  assert.deepEqual(deciders(summary).map(({name}) => name), ['c', 'a', 'chance']);
  assert.equal(decider_words(deciders(summary)[0]!), '0.7 ± 0.1');
  assert.deepEqual(check_rows(summary).map(([, value]) => value),
    ['± 1.5 m: 2 members with 4 seeds each', '+1.2 ± 0.4 m over 2 pairs']);
  assert.deepEqual(deciders({...summary, indices: {a: null}, chance: null}), []);
});

test('what is known of an ensemble says how it ended', () => {
  const rows = summary_rows({members: 16, by_status: {'at-rest': 13, stable: 3}, ended_by: 'max-members',
    half_width: 0.23, wanted_half_width: 0.05, probability_of_sliding: {value: 0.8125, low: 0.5, high: 0.95}} as
    unknown as Ensemble);
  assert.deepEqual(rows.map(([, value]) => value), ['81.3 % (50 % – 95 %)', '16: 13 slid, at rest, 3 stable',
    'the most members allowed', '± 23 % (wanted ± 5 %)']);
});

test('a difference of distances needs both measured', () => {
  assert.equal(quantile_difference(quantile(10, 'measured'), quantile(25, 'measured')), 15);
  assert.equal(quantile_difference(quantile(10, 'measured'), quantile(25, 'lower-bound')), null);
  assert.equal(quantile_difference(quantile(10, 'measured'), undefined), null);
});

/** The text of a source file of the server. */
function source(path: string): string {
  return readFileSync(join(process.env.LEDA_SOURCE!, path), 'utf8');
}

test('colours of probability are those of the exports', () => {
  const text = source('profiles/probability_colours.hpp');
  for (const kind of ['release', 'runout'] as const) {
    const [, list] = new RegExp(`${kind}_colours\\{\\s*\\{([^;]*)\\}\\};`).exec(text)!;
    const exported = [...list!.matchAll(/\{(\d+), (\d+), (\d+)\}/g)].map(([, ...rgb]) =>
      `#${rgb.map((one) => Number(one).toString(16).padStart(2, '0')).join('')}`);
    assert.deepEqual([0.05, 0.2, 0.5, 0.8, 0.95].map((share) => probability_colour(kind, share)), exported);
  }
});

test('the condition that the server states is said in the language of the reader', () => {
  const text = source('server/documents/ensemble_document.hpp');
  const [, first, second] = /ensemble_condition =\s*"([^"]*)"\s*"([^"]*)"/.exec(text)!;
  assert.match(condition_words(first! + second!), /^Conditional on a slide starting at the section/);
  assert.equal(condition_words('on Sundays'), 'on Sundays');
});

test('a job has an ensemble where its request has one', () => {
  assert.equal(has_ensemble({request: {inputs: {ensemble: {}}}} as unknown as JobMap), true);
  assert.equal(has_ensemble({request: {inputs: {}}} as unknown as JobMap), false);
  assert.equal(has_ensemble(null), false);
});
