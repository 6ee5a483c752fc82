// How sure a region is: what an ensemble says of its sections, on the map, in the panel and as files.

import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {Server, small, source, with_browser} from './leda_in_a_browser.mjs';

/** Two sections of the demo, coarse, with the fewest members there may be. */
const region = JSON.parse(readFileSync(join(source, 'deploy/demo/region.json'), 'utf8'));
region.inputs.sections = region.inputs.sections.slice(0, 2);
region.inputs.resolution.cell_m = 3;
region.inputs.ensemble = {
  inputs: [
    {name: 'su', path: '/soil/materials/*/peak_strength_kPa', apply: 'scale', scope: 'region',
      distribution: {type: 'lognormal', mean: 1, cov: 0.4}},
  ],
  sampling: {replicates: 4}, stop: {min_members: 16, max_members: 16, half_width: 0.01}, check: {members: 2, seeds: 2},
};

const server = new Server();
let job = '';
before(async () => {
  await server.start();
  await server.ask('POST', '/rasters?name=sainte-monique', readFileSync(server.dem), 'image/tiff');
  job = await server.run(region);
});
after(() => server.end());

async function open_job(page, section = '') {
  await page.goto(`${server.url}/#job=${job}${section ? `&section=${encodeURIComponent(section)}` : ''}`);
  await page.reload();
  await page.waitForSelector(`[data-section="AA'"]`);
}

/** Pixels of the map with about this colour. */
function coloured(page, rgb) {
  return page.evaluate(([r, g, b]) => [...document.querySelectorAll('.ol-layer canvas')].reduce((count, canvas) => {
    if (canvas.width === 0) return count;
    const still = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
    still.drawImage(canvas, 0, 0);
    const {data} = still.getImageData(0, 0, canvas.width, canvas.height);
    for (let i = 0; i < data.length; i += 4) {
      const off = Math.abs(data[i] - r) + Math.abs(data[i + 1] - g) + Math.abs(data[i + 2] - b);
      if (data[i + 3] > 150 && off <= 8) ++count;
    }
    return count;
  }, 0), rgb);
}

test('zones of probability are on the map, in the colours that the legend explains', () => with_browser(server, async (
  browser, page) => {
  const {features} = await server.ask('GET', `/collections/probability_zones/items?limit=1000&job=${job}`);
  const {probability_zones: zones} = await server.ask('GET', `/jobs/${job}/map`);
  assert.ok(zones.length > 0);
  assert.equal(features.length, zones.length, 'the map has what the collection has');
  await open_job(page);
  await page.waitForSelector('.legend .probabilities');
  const legend = await page.textContent('.legend');
  assert.match(legend, /Probability of release/);
  assert.match(legend, /Conditional on a slide starting at the section/);
  for (const exceedance of new Set(zones.map((zone) => zone.exceedance))) {
    assert.ok(legend.includes(`${100 * exceedance} % of runs go beyond it`), `${exceedance} in: ${legend}`);
  }
  await page.uncheck('.legend label:has-text("Hillshade") input');
  await page.waitForTimeout(700);
  await browser.picture('probability');
  // YlOrRd's third colour, of half of the runs.
  assert.ok(await coloured(page, [253, 141, 60]) > 200, 'half of the runs release this');
  await page.uncheck('.legend label:has-text("Probability of release") input');
  await page.waitForTimeout(500);
  assert.equal(await coloured(page, [253, 141, 60]), 0, 'switched off');
  browser.expect_silence();
}));

test('a section says how sure it is', () => with_browser(server, async (browser, page) => {
  const ensemble = await server.ask('GET', `/jobs/${job}/sections/AA'/ensemble`);
  await open_job(page, "AA'");
  await page.waitForSelector('.panel svg.profile');
  await page.focus('#tab-profile');
  await page.keyboard.press('ArrowRight');
  await page.waitForSelector('.exceedance canvas');
  await page.waitForTimeout(300);
  await browser.picture('how-sure');
  const panel = await page.textContent('.panel');
  const {value} = ensemble.probability_of_sliding;
  assert.ok(panel.includes(`Probability of sliding: ${Math.round(1000 * value) / 10} %`), panel);
  assert.match(panel, /16: .*slid, at rest/);
  assert.match(panel, /the most members allowed/);
  const rows = await page.locator('.distances section').first().locator('table').first().locator('tbody tr').allInnerTexts();
  assert.equal(rows.length, ensemble.retrogression.quantiles.length);
  const median = ensemble.retrogression.quantiles.findIndex(({exceedance}) => exceedance === 0.5);
  assert.ok(rows[median].includes(String(Math.round(10 * ensemble.retrogression.quantiles[median].distance_m) / 10)),
    rows[median]);
  const drawn = await page.evaluate(() => [...document.querySelectorAll('.exceedance canvas')].map((canvas) => {
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
    copy.drawImage(canvas, 0, 0);
    const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
    let line = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i] === 0xd5 && data[i + 1] === 0x5e && data[i + 2] === 0) ++line;
    return line;
  }));
  assert.equal(drawn.length, 2);
  for (const line of drawn) assert.ok(line > 200, `a curve is drawn: ${drawn}`);
  // Scrolled to its end the condition still shows.
  await page.evaluate(() => document.querySelector('#section-content').scrollTo(0, 10_000));
  const [content, condition] = await Promise.all(['#section-content', '.panel .condition'].map((one) =>
    page.locator(one).boundingBox()));
  assert.ok(condition.y >= content.y - 8 && condition.y + condition.height <= content.y + content.height);
  await browser.expect_accessible('how sure');
  browser.expect_silence();
}));

test('a narrow window has room for it too, in French', () => with_browser(server, async (browser, page) => {
  await open_job(page, "BB'");
  await page.waitForSelector('.panel:not([hidden])');
  await page.click('#tab-ensemble');
  await page.waitForSelector('.exceedance canvas');
  assert.match(await page.textContent('.panel .condition'), /Sous condition qu’un glissement/);
  const [width, most] = await page.evaluate(() => {
    const content = document.querySelector('#section-content');
    return [content.scrollWidth, content.clientWidth];
  });
  assert.ok(width <= most, `${width} of ${most} pixels`);
  await browser.picture('how-sure-narrow');
  await browser.expect_accessible('how sure, narrow');
  await browser.step('compare');
  await page.waitForSelector('.stage .exceedance canvas');
  await browser.expect_accessible('compare, narrow');
  browser.expect_silence();
}, {locale: 'fr-CA', viewport: small}));

test('curves, members, rasters and particles are taken away', () => with_browser(server, async (browser, page) => {
  await open_job(page, "AA'");
  await page.waitForSelector('.panel:not([hidden])');
  await page.click('#tab-ensemble');
  const curves = await browser.downloaded('text="Curves as SVG"');
  assert.match(curves.bytes.toString(), /^<svg/);
  await page.click('#tab-numbers');
  const fields = await browser.downloaded('text="Particles as HDF5"');
  assert.equal(fields.bytes.subarray(1, 4).toString(), 'HDF');
  await browser.step('take');
  await browser.expect_accessible('take');
  const members = await browser.downloaded('.step[data-step=take] >> text="Members as CSV"');
  assert.match(members.bytes.toString(), /^section,member,kind,weight,su,/);
  assert.equal(members.bytes.toString().trim().split('\n').length, 1 + 2 * (16 + 2));
  for (const kind of ['release', 'runout']) {
    const raster = await browser.downloaded(`text="Probability of ${kind}, GeoTIFF"`);
    assert.equal(raster.name, `${kind}_probability.tif`);
    assert.equal(raster.bytes.subarray(0, 2).toString(), 'II');
  }
  const style = await browser.downloaded('text="Style for QGIS" >> nth=0');
  assert.equal(style.name, 'release_probability.qml');
  const member = await fetch(`${server.url}/jobs/${job}/sections/${encodeURIComponent("AA' member-3")}/fields.h5`);
  assert.equal(member.status, 404);
  assert.match((await member.json()).detail, /a member of an ensemble/);
  browser.expect_silence();
}));

test('two sections are compared by their curves', () => with_browser(server, async (browser, page) => {
  const {ensembles} = await server.ask('GET', `/jobs/${job}/compare?sections=AA',BB'`);
  await open_job(page);
  await browser.step('compare');
  await page.waitForFunction(() => document.querySelectorAll('.stage .exceedance canvas').length === 2);
  await page.waitForTimeout(300);
  await browser.picture('compare-curves');
  assert.match(await page.textContent('.stage .condition'), /Conditional on a slide/);
  assert.match(await page.textContent('.stage .exceedance-figure .key'), /AA'\s*BB'/);
  const cells = await page.locator('.curve-numbers tbody tr td:last-child').allInnerTexts();
  const [{quantiles}] = ensembles.differences;
  assert.equal(cells.length, 1 + 2 * quantiles.length);
  const written = (metres) => (metres === null ? '–' : `${metres > 0 ? '+' : ''}${Math.round(10 * metres) / 10} m`);
  assert.deepEqual(cells.slice(1), ['retrogression_m', 'runout_m'].flatMap((of) =>
    quantiles.map((one) => written(one[of]).replace('-0 m', '0 m'))));
  const drawing = await browser.downloaded('.step[data-step=compare] >> text="Curves as SVG"');
  assert.match(drawing.bytes.toString(), /BB&#39;|BB&apos;|BB'/);
  await browser.expect_accessible('compare');
  browser.expect_silence();
}));

test('the report holds what an ensemble says, and on what condition', () => with_browser(server, async (browser, page) => {
  await open_job(page);
  await browser.step('take');
  const {bytes} = await browser.downloaded('text="Report as one HTML file"');
  const report = bytes.toString();
  assert.equal(report.match(/<h4>How sure<\/h4>/g).length, 2, 'one a section');
  assert.equal(report.match(/Conditional on a slide starting at the section: no yearly probability/g).length, 2);
  assert.match(report, /Zones of probability/);
  assert.match(report, /data:image\/svg\+xml;base64,/);
  assert.doesNotMatch(report, /src="(?!data:)/, 'nothing is fetched');
  browser.expect_silence();
}));

test('uncertain numbers stand in the form: imported, edited, kept, refused at their place, and sent', () => with_browser(
  server, async (browser, page) => {
    await browser.import_request(server, region);
    const at = (pointer) => page.locator(`[data-pointer="/inputs/ensemble${pointer}"]`).last();
    assert.equal(await at('/inputs/0/path').locator('input').inputValue(), '/soil/materials/*/peak_strength_kPa');
    await at('/inputs/0/distribution/cov').locator('input').fill('0,3');
    await at('/inputs/0/path').locator('input').fill('/soil/materials/none/k0');
    await page.reload();
    await browser.step('soil');
    await page.waitForSelector('fieldset.model');
    assert.equal(await at('/inputs/0/distribution/cov').locator('input').inputValue(), '0.3');
    const {inputs} = JSON.parse((await browser.downloaded('text="Export request"')).bytes);
    const edited = JSON.parse(JSON.stringify(region.inputs.ensemble));
    edited.inputs[0].distribution.cov = 0.3;
    edited.inputs[0].path = '/soil/materials/none/k0';
    assert.deepEqual(inputs.ensemble, edited);
    await browser.step('run');
    await page.click('text="Dry run"');
    await page.waitForSelector('.step[data-step=run] [role=alert]');
    assert.equal(await page.locator('nav [data-step=soil] .faults').textContent(), ' 1');
    await browser.step('soil');
    assert.match(await at('/inputs/0/path').locator('.fault').textContent(), /none/);
    await browser.picture('form-of-an-ensemble');
    await browser.expect_accessible('form');
    await at('/inputs/0/path').locator('input').fill('/soil/materials/*/peak_strength_kPa');
    await browser.step('run');
    await page.click('text="Dry run"');
    await page.waitForSelector('text="The request is sound."');
    assert.match(await page.textContent('.step[data-step=run] .facts'), /Runs38/);
    browser.expect_silence(/status of 400/);
  }));

test('an ensemble is made in the form from nothing', () => with_browser(server, async (browser, page) => {
  const {ensemble, ...certain} = region.inputs;
  await browser.import_request(server, {inputs: certain});
  const box = page.locator('.step[data-step=soil] [data-pointer="/inputs/ensemble"]').first();
  await box.locator('select.adder').selectOption('ensemble');
  const input = page.locator('[data-pointer="/inputs/ensemble/inputs/0"]').last();
  await input.locator('[data-pointer$="/name"] input').fill('strength');
  const suggested = await input.locator('datalist option').evaluateAll((options) => options.map(({value}) => value));
  assert.ok(suggested.includes('/soil/materials/*/peak_strength_kPa'), suggested.join(' '));
  await input.locator('[data-pointer$="/path"] input').fill('/soil/materials/S1/peak_strength_kPa');
  await input.locator('select[aria-label="Distribution: kind"]').selectOption({label: 'discrete'});
  for (const [member, values] of [['values', ['35', '45']], ['weights', ['0.4', '0.6']]]) {
    const list = input.locator(`fieldset[data-pointer$="/distribution/${member}"]`);
    while (await list.locator('input').count() < 2) await list.locator('text="Add"').click();
    for (const [i, value] of values.entries()) await list.locator('input').nth(i).fill(value);
  }
  const {inputs} = JSON.parse((await browser.downloaded('text="Export request"')).bytes);
  assert.deepEqual(inputs.ensemble, {inputs: [{name: 'strength', path: '/soil/materials/S1/peak_strength_kPa',
    distribution: {type: 'discrete', values: [35, 45], weights: [0.4, 0.6]}}]});
  await browser.step('run');
  await page.click('text="Dry run"');
  await page.waitForSelector('text="The request is sound."');
  assert.match(await page.textContent('.step[data-step=run] .facts'), /Core-hoursat least/);
  browser.expect_silence();
}));
