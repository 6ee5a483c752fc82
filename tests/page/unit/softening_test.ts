// The curve as the page draws it is that of the thesis: the same points that the solver is held to.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {last_strain, softening_curve, strength} from '../../../server/page/src/softening';

function table(name: string): Record<string, string>[] {
  const lines = readFileSync(join(process.env.LEDA_SOURCE!, 'tests/data', name),
    'utf8').trim().split('\n').filter((line) => !line.startsWith('#'));
  const head = lines[0]!.split(',');
  return lines.slice(1).map((line) => Object.fromEntries(line.split(',').map((cell, i) => [head[i]!, cell])));
}

test('the law of Urmi et al. at the published sites', () => {
  const rows = table('softening_law_points.csv');
  assert.ok(rows.length > 10);
  for (const row of rows) {
    const law = {law: 'urmi', alpha: Number(row.alpha), beta: Number(row.beta),
      residual_strain: Number(row.residual_strain),
      remolded_strength_kPa: Number(row.remolded_kPa)};
    const curve = softening_curve(law, Number(row.peak_kPa))!;
    const found = strength(curve, Number(row.strain));
    assert.ok(Math.abs(found - Number(row.strength_kPa)) <= Number(row.tolerance_kPa),
      `${row.site} at ${row.strain}: ${found}`);
  }
});

test('every law falls from the peak to the remolded strength', () => {
  const common = {remolded_strength_kPa: 1};
  const laws = [
    {...common, law: 'einav-randolph', strain_95: 2}, {...common, law: 'exponential', shape_factor: 5},
    {...common, law: 'linear', remolded_strain: 3},
    {...common, law: 'dey', strain_95: 1, large_strain: 10, large_strain_strength_kPa: 0.5},
  ];
  for (const law of laws) {
    const curve = softening_curve(law, 40)!;
    assert.equal(strength(curve, 0), 40, law.law);
    assert.ok(strength(curve, last_strain(curve)) < 1.5, law.law);
  }
});

test('a cell as large as the specimen changes nothing, a larger one steepens the fall', () => {
  const law = {law: 'urmi', alpha: 1, beta: 2, residual_strain: 2, remolded_strength_kPa: 1, reference_size_m: 0.5};
  const measured = softening_curve(law, 40)!;
  assert.deepEqual(softening_curve(law, 40, 0.5), measured);
  assert.ok(strength(softening_curve(law, 40, 1)!, 0.3) < strength(measured, 0.3));
  assert.deepEqual(softening_curve({...law, regularization: 'none'}, 40, 1), measured);
  assert.equal(softening_curve({...law, regularization: 'whole-curve'}, 40, 1)!.exp_end, 1);
});

test('a number that is missing or is no number gives no curve', () => {
  assert.equal(softening_curve({law: 'urmi', alpha: 1, beta: 'x', residual_strain: 2, remolded_strength_kPa: 1}, 40),
    null);
  assert.equal(softening_curve({law: 'linear', remolded_strength_kPa: 1}, 40), null);
  assert.equal(softening_curve({law: 'unheard-of'}, 40), null);
});
