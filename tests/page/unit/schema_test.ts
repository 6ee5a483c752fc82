import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {paths_to_numbers} from '../../../server/page/src/form/paths';
import {type Schema, Schemas, pointer_part, typed_number, unit_of,
  variant_name} from '../../../server/page/src/form/schema';
import {words} from '../../../server/page/src/words';
import type {JsonObject} from '../../../server/page/src/types';

const folder = join(process.env.LEDA_SOURCE!, 'server/documents/schema');
const read = (name: string) => JSON.parse(readFileSync(join(folder, name), 'utf8'));
const region = read('region.json') as Schema;
const schemas = new Schemas({...region, definitions: {...region.definitions, ...read('definitions.json')}});

test('the variant of a value is the one it is written in', () => {
  const strength = schemas.variants(schemas.resolve({$ref: '#/definitions/strength'}));
  assert.deepEqual(strength.map(variant_name), ['number', 'at_depth_m', 'at_elevation_m']);
  assert.equal(schemas.variant_of(strength, 40), 0);
  assert.equal(schemas.variant_of(strength, {at_elevation_m: [[0, 25]]}), 2);
  const laws = schemas.variants(schemas.resolve({$ref: '#/definitions/softening'}));
  assert.equal(variant_name(laws[schemas.variant_of(laws, {law: 'dey'})]!), 'dey');
  // "one of two moduli" is no choice of form.
  assert.deepEqual(schemas.variants(schemas.resolve({$ref: '#/definitions/material'})), []);
});

test('variants of one name are told by what they hold, and by their name while that is missing', () => {
  const laws = schemas.variants(schemas.resolve({$ref: '#/definitions/distribution'}));
  const variant = (value: JsonObject) => laws[schemas.variant_of(laws, value)]!.required!.join(' ');
  assert.equal(variant({type: 'lognormal', mean: 1, cov: 0.2}), 'type mean cov');
  assert.equal(variant({type: 'lognormal', median: 1, sd_ln: 0.2}), 'type median sd_ln');
  assert.equal(variant({type: 'pert', min: 1, mode: 2, max: 3}), 'type min mode max');
  assert.equal(variant({type: 'uniform', min: 1}), 'type min max');
  assert.equal(variant({type: 'discrete', values: [1], weights: [1]}), 'type values weights');
  assert.equal(variant_name(laws[schemas.variant_of(laws, {type: 'pert'})]!), 'triangular, pert');
});

test('numbers of a request are found by their pointers, those of all materials by one', () => {
  const soil = {base_m: 0, materials: {S1: {k0: 0.5, softening: {alpha: 0.9, law: 'urmi'}}, 'B/1': {k0: 0.6}}};
  assert.deepEqual(paths_to_numbers({soil, name: 'x', trigger: {kind: 'undrained', then_toe_cut_m: 3}} as JsonObject), [
    '/soil/materials/*/k0', '/soil/base_m', '/soil/materials/S1/k0', '/soil/materials/S1/softening/alpha',
    '/soil/materials/B~11/k0', '/trigger/then_toe_cut_m']);
});

test('a blank value holds what must be there, and constants', () => {
  assert.deepEqual(schemas.blank({$ref: '#/definitions/trigger_undrained'}), {kind: 'undrained'});
  const softening = schemas.blank({$ref: '#/definitions/softening'}) as JsonObject;
  assert.equal(softening.law, 'urmi');
  assert.ok('alpha' in softening);
  const {inputs} = schemas.blank({$ref: '#/definitions/ensemble'}) as {inputs: JsonObject[]};
  assert.deepEqual(Object.keys(inputs[0]!), ['name', 'path', 'distribution']);
});

test('units stand in names', () => {
  const expected = {cell_m: 'm', peak_strength_kPa: 'kPa', unit_weight_kN_m3: 'kN/m³', friction_angle_deg: '°',
    max_time_s: 's',
    viscosity_Pa_s: 'Pa s', reference_rate_per_s: '1/s', alpha: '', k0: ''};
  for (const [name, unit] of Object.entries(expected)) assert.equal(unit_of(name), unit, name);
});

test('numbers are read with either decimal sign, other text is kept as it is', () => {
  assert.equal(typed_number('2,5'), 2.5);
  assert.equal(typed_number(' 1e3 '), 1000);
  assert.equal(typed_number('−4'), -4);
  assert.equal(typed_number(''), undefined);
  assert.equal(typed_number('two'), 'two');
  assert.equal(pointer_part('a/b~c'), 'a~1b~0c');
});

test('every member of the schema has a label in both languages', () => {
  const seen = new Set<string>();
  const look = (schema: Schema, depth = 0) => {
    const form = schemas.resolve(schema);
    if (depth > 12) return;
    for (const [name, member] of Object.entries(form.properties ?? {})) {
      seen.add(name);
      look(member, depth + 1);
    }
    for (const one of [...(form.oneOf ?? []), form.items, form.additionalProperties].flat()) {
      if (typeof one === 'object') look(one, depth + 1);
    }
  };
  look({$ref: '#/definitions/soil_model'});
  look({$ref: '#/definitions/ensemble'});
  for (const name of ['trigger', 'resolution', 'damping', 'time_step_factor', 'stop', 'output', 'screening']) {
    seen.add(name);
    look(region.properties!.inputs!.properties![name]!);
  }
  assert.ok(seen.size > 40);
  for (const name of seen) assert.ok(`field_${name}` in words.en, name);
  assert.deepEqual(Object.keys(words.fr).sort(), Object.keys(words.en).sort());
});

test('both languages have the same places to fill', () => {
  const places = (text: string) => (text.match(/\{\w+\}/g) ?? []).sort();
  for (const [name, text] of Object.entries(words.en)) {
    assert.deepEqual(places(words.fr[name as keyof typeof words.fr]), places(text), name);
  }
});
