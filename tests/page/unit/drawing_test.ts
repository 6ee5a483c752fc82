import assert from 'node:assert/strict';
import {test} from 'node:test';
import {height_at, point_along, scale, ticks} from '../../../server/page/src/drawing/axes';
import {layers_on} from '../../../server/page/src/drawing/soil_layers';
import {colour_sections, limits_of, step_colour, steps_of_numbers} from '../../../server/page/src/colours';
import {escape} from '../../../server/page/src/report';
import {spacing_of, unpack_frames, unpacked} from '../../../server/page/src/section/frames';
import {name_from} from '../../../server/page/src/steps/dem_step';
import {next_name, points_from, points_text} from '../../../server/page/src/steps/draw_step';
import {take_events} from '../../../server/page/src/events';
import {step_of} from '../../../server/page/src/state';
import type {JobMap, XY} from '../../../server/page/src/types';

test('ticks are round and lie within', () => {
  assert.deepEqual(ticks(-0.3, 20.9, 4), [0, 10, 20]);
  assert.deepEqual(ticks(0, 0.4, 4), [0, 0.1, 0.2, 0.30000000000000004, 0.4]);
  assert.deepEqual(ticks(5, 5, 4), []);
  assert.equal(scale(10, 20, 0, 100)(15), 50);
});

test('a profile is read between its points and nowhere else', () => {
  const line: XY[] = [[0, 10], [10, 20], [10, 5], [20, 5]];
  assert.equal(height_at(line, 5), 15);
  assert.equal(height_at(line, 21), null);
});

test('a share of a trace is a point of the map', () => {
  assert.deepEqual(point_along([[0, 0], [10, 0], [10, 10]], 0.75), [10, 5]);
  assert.deepEqual(point_along([[0, 0], [10, 0]], 2), [10, 0]);
});

test('layers lie under each other, from the ground to the base', () => {
  const profile: XY[] = [[0, 20], [50, 20], [80, 5]];
  const soil = {base_below_toe_m: 5, layers: [{material: 'crust', thickness_m: 2}, {material: 'clay',
    bottom_below_toe_m: -3}, {material: 'base'}]};
  const [crust, clay, base] = layers_on(profile, 5, soil);
  assert.deepEqual(crust!.bottom.map((p) => p[1]), [18, 18, 3]);
  // At the toe the clay has wedged out.
  assert.deepEqual(clay!.bottom.map((p) => p[1]), [8, 8, 3]);
  assert.deepEqual(base!.bottom.map((p) => p[1]), [0, 0, 0]);
  assert.equal(layers_on(profile, 5, {layers: [{material: 'x'}, {material: 'y'}]}).length, 0);
});

test('limits of colours are round and reach the largest number', () => {
  const limits = limits_of(103.2, 6);
  assert.equal(limits.length, 6);
  assert.ok(limits[5]! >= 103.2);
  assert.equal(step_colour(0, limits), steps_of_numbers[0]);
  assert.equal(step_colour(103.2, limits), step_colour(limits[5]!, limits));
  assert.equal(step_colour(null, limits), '#8a8a8a');
});

test('a lower bound is dashed, and the legend says so', () => {
  const map = {sections: {
    name: ['A', 'B'], status: ['at-rest', 'left-domain'], retrogression_m: [50, 100], retrogression_is: ['measured',
      'lower-bound'],
    runout_m: [null, null], runout_is: [null, null], run_time_s: [1, 1],
  }} as unknown as JobMap;
  const {of, entries} = colour_sections(map, 'retrogression');
  assert.deepEqual(of.map(({dashed}) => dashed), [false, true]);
  assert.ok(entries.some(({dashed}) => dashed));
});

function packed(head: object, numbers: readonly number[]): ArrayBuffer {
  let text = JSON.stringify(head);
  text += ' '.repeat((4 - (text.length % 4)) % 4);
  const bytes = new ArrayBuffer(4 + text.length + 2 * numbers.length);
  new DataView(bytes).setUint32(0, text.length, true);
  new Uint8Array(bytes).set(new TextEncoder().encode(text), 4);
  new Uint16Array(bytes, 4 + text.length).set(numbers);
  return bytes;
}

const head = {field: 'speed', unit: 'm/s', first: 0, times_s: [0, 1], materials: [], particles: [2, 1], x_m: [0, 65535],
  z_m: [0, 10], value: [0, 1]};

test('frames come out of their bytes', () => {
  const {frames} = unpack_frames(packed(head, [0, 3, 1, 1, 0, 65535, 7, 8, 9]));
  assert.deepEqual([...frames[0]!.x], [0, 3]);
  assert.deepEqual([...frames[1]!.value], [9]);
  assert.equal(unpacked(frames[0]!.value[1]!, [0, 2]), 2);
  assert.equal(spacing_of(frames[0]!), 3);
});

test('frames that end too early are refused', () => {
  assert.throws(() => unpack_frames(packed(head, [0, 3, 1])), /too early/);
});

test('events are taken whole, the rest waits', () => {
  const {events, rest} = take_events('id: 1\nevent: status\ndata: {"a":1}\n\n: still there\n\nid: 2\nda');
  assert.deepEqual(events, [{id: '1', data: '{"a":1}'}]);
  assert.equal(rest, 'id: 2\nda');
});

test('names and points as a user writes them', () => {
  assert.equal(next_name([]), "AA'");
  assert.equal(next_name([{name: "AA'"}, {name: "BB'"}]), "CC'");
  assert.equal(name_from('my dem*.v2.tif'), 'my dem-.v2');
  assert.deepEqual(points_from('1 2\n3;4\n 5, 6'), [[1, 2], [3, 4], [5, 6]]);
  assert.equal(points_from('1 2\n3'), null);
  assert.equal(points_text([[1, 2.006]]), '1.00 2.01');
});

test('a fault leads to the step where its value is typed', () => {
  assert.equal(step_of('/inputs/sections/0/name'), 'draw');
  assert.equal(step_of('/inputs/dem'), 'dem');
  assert.equal(step_of('/inputs/name'), 'run');
  assert.equal(step_of('/inputs/soil/layers/0'), 'soil');
  assert.equal(step_of('/inputs/resolution/cell_m'), 'soil');
});

test('what a report shows is text, never markup', () => {
  assert.equal(escape('<b a="1">\'&'), '&#60;b a=&#34;1&#34;&#62;&#39;&#38;');
});
