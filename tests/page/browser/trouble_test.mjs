// What goes wrong is said where it is typed, and nothing that was typed is lost.

import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {Server, source, with_browser} from './leda_in_a_browser.mjs';

const region = JSON.parse(readFileSync(join(source, 'deploy/demo/region.json'), 'utf8'));
region.inputs.resolution.cell_m = 2;

/** Whether the map has the colour of a chosen line; the hillshade, which may have it too, must be off. */
function is_marked(page) {
  return page.evaluate(() => [...document.querySelectorAll('.ol-layer canvas')].some((canvas) => {
    if (canvas.width === 0) return false;
    const still = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
    still.drawImage(canvas, 0, 0);
    const {data} = still.getImageData(0, 0, canvas.width, canvas.height);
    let marked = 0;
    for (let i = 0; i < data.length; i += 4) {
      if (data[i] === 0x11 && data[i + 1] === 0x11 && data[i + 2] === 0x11 && data[i + 3] === 255) ++marked;
    }
    return marked > 50;
  }));
}

const copy = (value) => JSON.parse(JSON.stringify(value));

const server = new Server();
let finished_job = '';
before(async () => {
  await server.start();
  await server.ask('POST', '/rasters?name=sainte-monique', readFileSync(server.dem), 'image/tiff');
  finished_job = await server.run(region);
});
after(() => server.end());

test('faults stand at their fields, and are counted at their steps', () => with_browser(server, async (browser,
  page) => {
  const wrong = copy(region);
  wrong.inputs.soil.materials.S1.poisson_ratio = 0.7;
  wrong.inputs.sections[0].name = "BB'";
  wrong.inputs.name = '';
  await browser.import_request(server, wrong);
  await browser.step('run');
  await page.click('text="Submit"');
  await page.waitForSelector('.step[data-step=run] [role=alert]');
  assert.equal(await page.locator('nav [data-step=soil] .faults').textContent(), ' 1');
  await page.click('.step[data-step=run] .warnings button:has-text("Soil")');
  const field = page.locator('[data-pointer="/inputs/soil/materials/S1/poisson_ratio"]');
  assert.match(await field.locator('.fault').textContent(), /0\.7/);
  assert.equal(await field.locator('input').getAttribute('aria-invalid'), 'true');
  assert.ok(await field.isVisible(), 'the material is unfolded');
  await browser.picture('faults');
  // A name twice is known as soon as it is typed.
  await browser.step('draw');
  await page.waitForSelector('[data-pointer="/inputs/sections/1/name"] .fault');
  // What was typed stands after the page is loaded again.
  await page.reload();
  await browser.step('soil');
  await page.waitForSelector('fieldset.model');
  await page.click('details.material summary:has-text("S1")');
  assert.equal(await field.locator('input').inputValue(), '0.7');
  browser.expect_silence(/status of 400/);
}));

test('what is not done yet is said in plain words', () => with_browser(server, async (browser, page) => {
  await browser.step('run');
  await page.fill('[data-pointer="/inputs/name"] input', '');
  await page.click('text="Dry run"');
  await page.waitForSelector('text="Give the job a name."');
  assert.match(await page.textContent('.step[data-step=run] .warnings'), /Draw a section or trace a line first/);
  await page.fill('[data-pointer="/inputs/name"] input', 'reach');
  await page.waitForFunction(() => document.querySelector('nav [data-step=run] .faults').textContent === '');
  assert.equal(await page.locator('nav [data-step=draw] .faults').textContent(), ' 1');
  browser.expect_silence(/status of 400/);
}));

test('a line outside the DEM is refused at its points', () => with_browser(server, async (browser, page) => {
  const outside = copy(region);
  outside.inputs.sections = [{name: "AA'", line: [[1, 2], [3, 4]]}];
  await browser.import_request(server, outside);
  await browser.step('draw');
  const fault = page.locator('[data-pointer="/inputs/sections/0/line"] .fault').first();
  await fault.waitFor();
  assert.match(await fault.textContent(), /outside the DEM/);
  browser.expect_silence(/status of 400/);
}));

test('a file that is no DEM, and one that is no request, say what to do', () => with_browser(server, async (browser,
  page) => {
  const file = join(server.folder, 'notes.txt');
  writeFileSync(file, 'no raster at all');
  await page.setInputFiles('.drop input[type=file]', file);
  await page.click('text="Upload"');
  const report = page.locator('.step[data-step=dem] .report.bad');
  await report.waitFor();
  assert.match(await report.textContent(), /GeoTIFF/);
  await browser.step('soil');
  await page.setInputFiles('.step[data-step=soil] input[type=file]', file);
  await page.waitForSelector('text=/This file is no request/');
  browser.expect_silence(/status of 400/);
}));

test('an upload that loses its connection can be sent again', () => with_browser(server, async (browser, page) => {
  await page.route('**/rasters?name=*', (route) => route.abort('connectionreset'), {times: 1});
  await page.setInputFiles('.drop input[type=file]', server.dem);
  await page.click('text="Upload"');
  await page.waitForSelector('text=/The connection was lost on the way/');
  await browser.upload(server.dem);
  browser.expect_silence(/ERR_CONNECTION_RESET/);
}));

test('a job is watched over a restart of the server', {timeout: 120_000}, () => with_browser(server, async (browser,
  page) => {
  const long = copy(region);
  long.inputs.resolution.cell_m = 0.6;
  long.inputs.output = {frame_interval_s: 1};
  await browser.import_request(server, long);
  await browser.step('run');
  await page.click('text="Submit"');
  await page.waitForFunction(() => /running/.test(document.querySelector('.jobs .card.chosen')?.textContent ?? ''));
  await server.stop();
  await page.waitForSelector('.banner:not([hidden])');
  await browser.picture('away');
  await browser.step('soil');
  await page.fill('[data-pointer="/inputs/resolution/cell_m"] input', '3');
  await server.start();
  await page.waitForSelector('.banner', {state: 'hidden'});
  assert.equal(await page.inputValue('[data-pointer="/inputs/resolution/cell_m"] input'), '3');
  await browser.step('look');
  await page.waitForFunction(() => /running/.test(document.querySelector('.jobs .card.chosen')?.textContent ?? ''));
  await page.click('text="Cancel"');
  await page.waitForFunction(() => /cancelled/.test(document.querySelector('.jobs .card.chosen')?.textContent ?? ''));
  browser.expect_silence(/ERR_CONNECTION_REFUSED/, /ERR_INCOMPLETE_CHUNKED_ENCODING/, /ERR_EMPTY_RESPONSE/,
    /ERR_CONNECTION_RESET/);
}));

test('a section that failed says why, and can be run again', async () => {
  const hasty = new Server({options: ['--run-time-limit-s', '1']});
  await hasty.start();
  try {
    await hasty.ask('POST', '/rasters?name=sainte-monique', readFileSync(hasty.dem), 'image/tiff');
    const long = copy(region);
    long.inputs.resolution.cell_m = 0.4;
    long.inputs.sections = long.inputs.sections.slice(0, 1);
    const {jobID} = await hasty.ask('POST', '/processes/map-region/execution', JSON.stringify(long));
    await with_browser(hasty, async (browser, page) => {
      await page.goto(`${hasty.url}/#job=${jobID}`);
      await page.reload();
      await page.click('text="Retry what failed"', {timeout: 60_000});
      await page.waitForFunction(() => /running|waiting/.test(document.querySelector(
        '.jobs .card.chosen')?.textContent ?? ''));
      await page.waitForSelector('text="Retry what failed"', {timeout: 60_000});
      await page.click(`[data-section="AA'"]`);
      await page.click('#tab-numbers');
      assert.match(await page.textContent('.panel .facts'), /took longer than it may/);
      browser.expect_silence();
    });
  } finally {
    await hasty.end();
  }
});

test('the address keeps the job and the section that show', () => with_browser(server, async (browser, page) => {
  await page.goto(`${server.url}/#job=${finished_job}`);
  await page.reload();
  await page.waitForFunction(() => /finished/.test(document.querySelector('.jobs .card.chosen')?.textContent ?? ''));
  assert.equal(await page.locator('text="Retry what failed"').count(), 0, 'nothing failed');
  await page.click(`[data-section="BB'"]`);
  await page.waitForSelector('.panel:not([hidden])');
  await page.reload();
  await page.waitForSelector('.panel svg.profile');
  assert.equal(await page.textContent('.panel h2'), "BB'");
  // It is marked on the map, also once the layout of what is drawn came in.
  await page.uncheck('.legend label:has-text("Hillshade") input');
  await page.waitForTimeout(800);
  assert.ok(await is_marked(page), 'the section is marked');
  browser.expect_silence();
}));

test('a refused token is said, and the right one lets in', async () => {
  const guarded = new Server({tokens: true});
  await guarded.start();
  try {
    await with_browser(guarded, async (browser, page) => {
      await browser.enter_token('leda_wrong');
      await page.waitForSelector('dialog .fault');
      await browser.picture('token');
      await browser.enter_token(guarded.token);
      await page.waitForSelector('text="No ground yet: upload one above."');
      await page.reload();
      await page.waitForSelector('text="No ground yet: upload one above."');
      assert.equal(await page.evaluate(() => JSON.stringify(localStorage).includes('leda_')), false,
        'kept for the session only');
      browser.expect_silence(/status of 401/);
    });
  } finally {
    await guarded.end();
  }
});

test('a browser that speaks French gets French, and the choice is kept', () => with_browser(server, async (browser,
  page) => {
  await page.waitForSelector('nav button:has-text("Résultats")');
  assert.equal(await page.getAttribute('html', 'lang'), 'fr');
  await browser.picture('french');
  await page.click('button:has-text("English")');
  await page.waitForSelector('nav button:has-text("Results")');
  await page.reload();
  await page.waitForSelector('nav button:has-text("Results")');
  browser.expect_silence();
}, {locale: 'fr-CA'}));

test('every step passes axe-core', () => with_browser(server, async (browser, page) => {
  await page.goto(`${server.url}/#job=${finished_job}`);
  await page.reload();
  await page.waitForSelector(`[data-section="BB'"]`);
  await browser.import_request(server, region);
  await page.waitForFunction(() => document.querySelectorAll('.pictures svg').length > 0);
  for (const details of await page.locator('details.material > summary').all()) await details.click();
  for (const step of ['dem', 'draw', 'soil', 'run', 'look', 'compare', 'take']) {
    await browser.step(step);
    await page.waitForTimeout(700);
    await browser.expect_accessible(step);
    if (step !== 'look') continue;
    await page.click(`[data-section="BB'"]`);
    for (const tab of ['profile', 'animation', 'numbers', 'screening', 'log']) {
      await page.click(`#tab-${tab}`);
      await page.waitForTimeout(400);
      await browser.expect_accessible(`look, ${tab}`);
    }
  }
  browser.expect_silence();
}));

test('the keyboard alone goes from the steps to a section and back', () => with_browser(server, async (browser,
  page) => {
  await page.goto(`${server.url}/#job=${finished_job}`);
  await page.reload();
  await page.waitForSelector(`[data-section="AA'"]`);
  for (const step of ['run', 'look']) {
    await page.focus(`nav [data-step=${step}]`);
    await page.keyboard.press('Enter');
    await page.waitForSelector(`.step[data-step=${step}]:not([hidden])`);
  }
  await page.focus(`[data-section="AA'"]`);
  await page.keyboard.press('Enter');
  await page.waitForSelector('.panel svg.profile');
  await page.focus('#tab-profile');
  await page.keyboard.press('ArrowRight');
  await page.waitForSelector('canvas[data-frame="0"]');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'tab-animation');
  await page.focus('.panel [aria-label=Close]');
  await page.keyboard.press('Enter');
  await page.waitForSelector('.panel', {state: 'hidden'});
  browser.expect_silence();
}));
