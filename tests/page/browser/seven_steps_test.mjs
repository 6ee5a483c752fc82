// From an empty data folder to zones on the map, as a user goes, at two sizes, with and without tokens.

import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Browser, Server, large, small} from './leda_in_a_browser.mjs';

/** Where the map has just this colour: that of a section, which nothing else has. */
async function coloured_point(page, rgb) {
  const found = await page.evaluate(([r, g, b]) => {
    for (const canvas of document.querySelectorAll('.ol-layer canvas')) {
      const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
      copy.drawImage(canvas, 0, 0);
      const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
      for (let i = 4 * canvas.width * Math.floor(canvas.height / 2); i < data.length; i += 4) {
        if (data[i] !== r || data[i + 1] !== g || data[i + 2] !== b) continue;
        const box = canvas.getBoundingClientRect();
        const scale = canvas.width / box.width;
        return [box.x + ((i / 4) % canvas.width) / scale, box.y + Math.floor(i / 4 / canvas.width) / scale];
      }
    }
    return null;
  }, rgb);
  assert.ok(found, 'a section is on the map');
  return found;
}

async function bring_a_dem(browser, server) {
  const {page} = browser;
  await browser.upload(server.dem);
  assert.match(await page.textContent('.about'), /EPSG:2950/);
  assert.match(await page.textContent('.about'), /760 × 760/);
  assert.equal(await page.inputValue('.step[data-step=dem] .field input'), 'sainte-monique');
  await page.waitForTimeout(600);
  const box = await page.locator('.map').boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForFunction(() => /Elevation [\d.]+ m/.test(document.querySelector('.readout')?.textContent ?? ''));
  await browser.picture('dem');
}

async function draw(browser) {
  const {page} = browser;
  await browser.step('draw');
  await page.click('text="Draw a section"');
  await browser.click_map(0.42, 0.15);
  await browser.click_map(0.48, 0.78);
  await page.waitForSelector('.step[data-step=draw] svg.profile');
  await page.click('text="Trace a line"');
  for (const [x, y] of [[0.3, 0.76], [0.42, 0.67]]) await browser.click_map(x, y);
  await browser.click_map(0.55, 0.6, 2);
  await page.waitForFunction(() => /[3-9] sections/.test(document.querySelector('.step[data-step=draw]').textContent));
  // A name of one's own; the profile of that section shows.
  await page.fill('.step[data-step=draw] .card .field input', "MM'");
  await page.waitForFunction(() => /Profile of MM'/.test(document.querySelector('.step[data-step=draw]').textContent));
  // The crest brought elsewhere by the keyboard is sent with the section.
  await page.focus('svg .handle[aria-label=crest]');
  const before = await page.getAttribute('svg .handle[aria-label=crest]', 'aria-valuenow');
  await page.keyboard.press('Shift+ArrowLeft');
  await page.waitForFunction((was) =>
    Math.abs(Number(document.querySelector('svg .handle[aria-label=crest]')?.getAttribute('aria-valuenow')) - (
      was - 10)) < 0.5, Number(before));
  await page.click('text="As the server finds them"');
  await browser.picture('draw');
}

async function describe_the_soil(browser) {
  const {page} = browser;
  await browser.step('soil');
  await page.waitForSelector('.step[data-step=soil] fieldset.model');
  await page.selectOption('select[aria-label="Start from"]', {label: 'Sainte-Monique'});
  await page.click('text="Use this soil"');
  await page.click('summary:has-text("Softening of S1")');
  await page.waitForSelector('.curve canvas');
  await page.fill('[data-pointer="/inputs/resolution/cell_m"] input', '2');
  await page.fill('[data-pointer="/inputs/output/frame_interval_s"] input', '1');
  assert.equal(await page.textContent('[data-pointer="/inputs/resolution/cell_m"] .unit'), 'm');
  await browser.picture('soil');
  const request = JSON.parse((await browser.downloaded('text="Export request"')).bytes);
  assert.equal(request.inputs.resolution.cell_m, 2);
  assert.equal(request.inputs.sections.length, 2);
  assert.equal(request.inputs.sections[0].name, "MM'");
  assert.equal(request.inputs.sections[0].crest, undefined);
}

async function run(browser) {
  const {page} = browser;
  await browser.step('run');
  await page.click('text="Dry run"');
  await page.waitForSelector('text="The request is sound."');
  assert.match(await page.textContent('.step[data-step=run] .facts'), /Core-hours/);
  await browser.picture('run');
  await page.click('text="Submit"');
  await page.waitForFunction(() => /finished/.test(document.querySelector('.jobs .card.chosen')?.textContent ?? ''),
    null, {timeout: 120_000});
}

async function look(browser) {
  const {page} = browser;
  await page.waitForFunction(() => document.querySelector('.legend')?.textContent.includes('Release zones'));
  await page.click(`[data-section="MM'"]`);
  await page.waitForSelector('.panel svg.profile');
  assert.match(await page.textContent('.panel'), /Retrogression (at least )?[\d.]+ m/);
  await browser.picture('look');
  await page.click('#tab-animation');
  await page.waitForSelector('canvas[data-frame="0"]');
  const drawn = () => page.evaluate(() => {
    const canvas = document.querySelector('canvas.particles');
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
    copy.drawImage(canvas, 0, 0);
    return copy.getImageData(0, 0, canvas.width, canvas.height).data.filter((byte) => byte !== 0).length;
  });
  assert.ok(await drawn() > 1000, 'particles are drawn');
  await page.click('text="Play"');
  await page.waitForFunction(() => Number(document.querySelector('canvas.particles').dataset.frame) > 5);
  await browser.picture('animation');
  await page.click('#tab-numbers');
  assert.match(await page.textContent('.panel .facts'), /Energy audit/);
  await page.click('#tab-log');
  assert.match(await page.textContent('.panel .log'), /\S/);
  await page.selectOption('.step[data-step=look] select', 'retrogression');
  await page.waitForFunction(() => / m/.test(document.querySelector('.legend .colours')?.textContent ?? ''));
  // The map itself leads to a section.
  await page.click('[aria-label=Close]');
  await page.selectOption('.step[data-step=look] select', 'status');
  await page.waitForTimeout(500);
  await page.mouse.click(...await coloured_point(page, [213, 94, 0]));
  await page.waitForSelector('.panel:not([hidden])');
}

async function compare(browser) {
  const {page} = browser;
  await browser.step('compare');
  await page.waitForFunction(() => document.querySelectorAll('.stage svg.profile').length === 2);
  assert.match(await page.textContent('.step[data-step=compare] table'), /Difference/);
  await browser.picture('compare');
}

async function take_away(browser) {
  const {page} = browser;
  await browser.step('take');
  const gpkg = await browser.downloaded('text="GeoPackage, styled for QGIS"');
  assert.match(gpkg.name, /\.gpkg$/);
  assert.equal(gpkg.bytes.subarray(0, 15).toString(), 'SQLite format 3');
  const shape = await browser.downloaded('text="Shapefile"');
  assert.match(shape.name, /\.zip$/);
  const report = await browser.downloaded('text="Report as one HTML file"');
  const html = report.bytes.toString();
  assert.match(html, /MM&#39;/);
  assert.match(html, /<img src="data:image\/png;base64,.{2000}/);
  assert.doesNotMatch(html, /<script|(src|href)="http/);
  await browser.picture('take');
  return html;
}

/** The report stands alone: a page with nothing but the file shows it. */
async function read_the_report(browser, html) {
  const other = await browser.page.context().newPage();
  await other.setContent(html);
  assert.ok(await other.locator('svg').count() >= 3);
  if (process.env.LEDA_PICTURES) await other.screenshot({path: `${process.env.LEDA_PICTURES}/report.png`});
  await other.close();
}

for (const tokens of [false, true]) {
  for (const viewport of [large, small]) {
    const size = `${viewport.width} x ${viewport.height}`;
    test(`seven steps at ${size}, ${tokens ? 'with' : 'without'} tokens`, {timeout: 240_000}, async () => {
      const server = new Server({tokens});
      const browser = await Browser.open({viewport});
      try {
        await server.start();
        await browser.page.goto(server.url);
        if (tokens) await browser.enter_token(server.token);
        await bring_a_dem(browser, server);
        await draw(browser);
        await describe_the_soil(browser);
        await run(browser);
        await look(browser);
        await compare(browser);
        await read_the_report(browser, await take_away(browser));
        browser.expect_silence(...(tokens ? [/status of 401/] : []));
      } catch (error) {
        await browser.picture(`failed-${size}`);
        throw error;
      } finally {
        await browser.close();
        await server.end();
      }
    });
  }
}
