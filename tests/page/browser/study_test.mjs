// A study in the list of jobs: its picture and what became of its settings.

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Server, with_browser} from './leda_in_a_browser.mjs';

/** A bank that is simulated in moments, with two cells. */
const study = {inputs: {
  name: 'bank study', cell_m: [1, 1.2], particles_per_cell: [4], seeds: 1, reference: 'finest',
  case: {
    name: 'bank', ground: [[0, 10], [50, 10], [56, 4], [90, 4]], base_m: 2, layers: [{material: 'clay'}],
    materials: {clay: {unit_weight_kN_m3: 17, shear_modulus_kPa: 1000, poisson_ratio: 0.45, peak_strength_kPa: 20,
      softening: {law: 'exponential', remolded_strength_kPa: 6, shape_factor: 8, regularization: 'none'}}},
    trigger: {kind: 'undrained', then_toe_cut_m: 3}, resolution: {cell_m: 1, particles_per_cell: 4},
    stop: {max_time_s: 60},
  },
}};

test('a study shows its picture, its outcome and its settings', async () => {
  const server = new Server();
  await server.start();
  try {
    const job = await server.run(study, 'resolution-study');
    const {settings, outcome} = await server.ask('GET', `/jobs/${job}/results`);
    await with_browser(server, async (browser, page) => {
      await browser.step('look');
      await page.waitForSelector(`[data-job="${job}"].chosen`);
      await page.waitForFunction(() => document.querySelector('.stage:not([hidden]) figure img')?.naturalWidth > 0);
      const text = await page.textContent('.step[data-step=look]');
      for (const line of outcome) assert.ok(text.includes(line), line);
      assert.match(text, /This job has no map/);
      assert.ok(await page.locator('.legend').isHidden(), 'nothing on the map to explain');
      const rows = await page.locator('.wide tbody tr').allInnerTexts();
      assert.deepEqual(rows.map((row) => Number(row.split(/\s/)[0])), settings.map(({cell_m}) => cell_m));
      const finest = rows.find((row) => Number(row.split(/\s/)[0]) === 1);
      assert.match(finest, /reference/);
      assert.ok(finest.includes(String(Math.round(10 * settings.find(({cell_m}) =>
        cell_m === 1).crest_to_crest_retrogression_m.mean) / 10)), finest);
      await browser.picture('study');
      await browser.expect_accessible('study');
      const csv = await browser.downloaded('text="Runs as CSV"');
      assert.match(csv.bytes.toString(), /^cell_m,particles_per_cell,time_step_factor,seed/);
      browser.expect_silence();
    });
  } finally {
    await server.end();
  }
});
