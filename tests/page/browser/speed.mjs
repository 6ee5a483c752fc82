// How fast the page is on a job of a server that runs: node speed.mjs URL JOB
// First view: from the address to sections on the map, medians of five loads. Pan and zoom: tasks of the
// main thread in the browser's own trace, and the pause between two frames.

import {readFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {Browser} from './leda_in_a_browser.mjs';

const [url, job] = process.argv.slice(2);
if (!job) throw new Error('usage: node speed.mjs URL JOB');

const browser = await Browser.open();
const {page} = browser;

/** Whether something of a saturated colour is drawn: the hillshade is grey. */
const sections_are_drawn = () => [...document.querySelectorAll('.ol-layer canvas')].some((canvas) => {
  if (canvas.width === 0) return false;
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
  copy.drawImage(canvas, 0, 0);
  const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
  for (let i = 0; i < data.length; i += 4) if (data[i] - data[i + 2] > 100 && data[i + 3] > 200) return true;
  return false;
});

const middle = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

const first_views = [];
for (let i = 0; i < 5; ++i) {
  await page.goto('about:blank');
  await page.goto(`${url}/#job=${job}`, {waitUntil: 'commit'});
  await page.waitForFunction(sections_are_drawn, null, {polling: 20});
  first_views.push(await page.evaluate(() => performance.now()));
}
console.log(`first view: ${Math.round(middle(first_views))} ms (${first_views.map(Math.round).join(', ')})`);

await page.waitForTimeout(1000);
const file = join(tmpdir(), `leda-trace-${process.pid}.json`);
await browser.program.startTracing(page, {path: file, categories: ['devtools.timeline', 'toplevel']});
await page.evaluate(() => {
  window.pauses = [];
  let last = performance.now();
  const count = (now) => {
    window.pauses.push(now - last);
    last = now;
    if (!window.enough) requestAnimationFrame(count);
  };
  requestAnimationFrame(count);
});
const box = await page.locator('.map').boundingBox();
const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
for (let round = 0; round < 3; ++round) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 0; i < 30; ++i) await page.mouse.move(x + 4 * i * (round % 2 ? -1 : 1), y + 2 * i);
  await page.mouse.up();
  for (let i = 0; i < 6; ++i) {
    await page.mouse.wheel(0, round % 2 ? 120 : -120);
    await page.waitForTimeout(60);
  }
}
await page.waitForTimeout(500);
const pauses = await page.evaluate(() => {
  window.enough = true;
  return window.pauses;
});
await browser.program.stopTracing();
const {traceEvents} = JSON.parse(readFileSync(file, 'utf8'));
const names = new Map(traceEvents.filter((e) => e.name === 'thread_name').map((e) => [`${e.pid} ${e.tid}`,
  e.args.name]));
const tasks = traceEvents.filter((e) => /RunTask$/.test(e.name) && e.dur &&
  names.get(`${e.pid} ${e.tid}`) === 'CrRendererMain')
  .map((e) => e.dur / 1000);
const above = (list, limit) => list.filter((one) => one > limit).length;
const of = (list) => `${above(list, 50)} above 50 ms, longest ${Math.round(Math.max(...list))} ms`;
console.log(`tasks of the main thread: ${tasks.length}, ${above(tasks, 16.7)} above 16.7 ms, ${of(tasks)}`);
console.log(`frames: ${pauses.length}, middle pause ${middle(pauses).toFixed(1)} ms, ${of(pauses)}`);
await browser.close();
