import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {draft_of, has_models, keep_draft, kept_draft, model_pointer, new_draft, preset, preset_names,
  request_of} from '../../../server/page/src/draft';
import presets from '../../../server/page/src/presets.json';
import type {Json} from '../../../server/page/src/types';

const source = process.env.LEDA_SOURCE!;
const read = (file: string) => JSON.parse(readFileSync(join(source, file), 'utf8'));

test('a request goes into the form and comes out as it was', () => {
  const request = read('deploy/demo/region.json') as Json;
  assert.deepEqual(request_of(draft_of(request)), request);
});

test('so does one with several soils', () => {
  const request = read('deploy/demo/region.json');
  const {soil} = request.inputs;
  request.inputs.soil = {models: [{name: 'scar', where: [[[0, 0], [1, 0], [1, 1]]], ...soil}, {name: 'clay', ...soil}]};
  const draft = draft_of(request as Json);
  assert.ok(has_models(draft));
  assert.equal(model_pointer(draft, 1), '/inputs/soil/models/1');
  assert.deepEqual(request_of(draft), request);
});

test('one line to lay sections along, which may stand without a list, becomes a list', () => {
  const request = read('deploy/demo/region.json');
  const along = request.inputs.sections[2];
  request.inputs.sections = along;
  assert.deepEqual(draft_of(request as Json).sections, [along]);
});

test('what is no request is said to be none', () => {
  for (const wrong of [null, 3, [], {}, {inputs: 3}, {inputs: {}}] as Json[]) assert.throws(() => draft_of(wrong),
    /missing/);
});

test('the form starts with soil written plainly', () => {
  const draft = new_draft();
  assert.equal(has_models(draft), false);
  assert.equal(model_pointer(draft, 0), '/inputs/soil');
});

test('presets are the cases of the thesis, with elevations counted from the toe', () => {
  assert.equal(preset_names.length, 4);
  presets.forEach((one, i) => {
    const published = read(`tests/validation/cases/${one.case}.json`);
    const {soil, trigger} = preset(i);
    assert.deepEqual(soil.materials, published.materials, one.name);
    assert.deepEqual(soil.water_table, published.water_table, one.name);
    assert.deepEqual(trigger, published.trigger, one.name);
    const toe = published.toe_m?.[1] ?? Math.min(...published.ground.map((p: number[]) => p[1]));
    assert.equal(soil.base_below_toe_m, toe - published.base_m, one.name);
    const layers = soil.layers as Record<string, unknown>[];
    published.layers.forEach((layer: Record<string, number>, at: number) => {
      const {bottom_m, ...rest} = layer;
      const expected = bottom_m === undefined ? rest : {...rest, bottom_below_toe_m: toe - bottom_m};
      assert.deepEqual(layers[at], expected, one.name);
    });
  });
});

test('an ensemble goes in, is kept over a reload, and comes out as it was', () => {
  const request = read('deploy/demo/region.json');
  request.inputs.ensemble = {
    inputs: [{name: 'su', path: '/soil/materials/*/peak_strength_kPa', apply: 'scale', scope: 'region',
      distribution: {type: 'lognormal', mean: 1, cov: 0.4}}],
    sampling: {replicates: 4}, stop: {min_members: 16}, exceedance: [0.05, 0.5],
  };
  let kept = '';
  const storage = globalThis.localStorage;
  globalThis.localStorage = {getItem: () => kept, setItem: (_: string, text: string) => (kept = text)} as unknown as Storage;
  keep_draft(draft_of(request as Json));
  assert.deepEqual(request_of(kept_draft()), request);
  globalThis.localStorage = storage;
});
