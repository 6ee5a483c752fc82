// A server over a folder of its own, and Debian's Chromium that looks at it. What the page must never do
// is watched throughout: ask another host, or say a word in the console that no test expects.

import assert from 'node:assert/strict';
import {spawn, spawnSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const require = createRequire(join(root, 'server/page/package.json'));
const {chromium} = require('playwright-core');
const axe_source = require('axe-core').source;

const leda = process.env.LEDA_PROGRAM ?? join(root, 'build/release/leda');
const write_demo_dem = process.env.LEDA_DEMO_DEM ?? join(root, 'build/release/write_demo_dem');
export const source = root;

export const large = {width: 1280, height: 800};
export const small = {width: 700, height: 900};

export class Server {
  constructor({tokens = false, options = []} = {}) {
    this.folder = mkdtempSync(join(tmpdir(), 'leda-page-'));
    this.data = join(this.folder, 'data');
    this.dem = join(this.folder, 'sainte-monique.tif');
    assert.equal(spawnSync(write_demo_dem, [this.dem]).status, 0);
    this.arguments = ['serve', '--data', this.data, '--workers', '2', ...options];
    this.token = '';
    if (tokens) {
      const file = join(this.folder, 'tokens');
      const made = spawnSync(leda, ['token', 'sam', '--role', 'submit'], {encoding: 'utf8'});
      assert.equal(made.status, 0, made.stderr);
      [this.token] = /leda_\S+/.exec(made.stdout + made.stderr);
      const [line] = /submit [0-9a-f]{64} sam/.exec(made.stdout + made.stderr);
      writeFileSync(file, `${line}\n`, {mode: 0o600});
      this.arguments.push('--tokens', file);
    }
  }

  /** Serves where it served before, or on a free port. */
  async start() {
    const listen = this.url ? new URL(this.url).host : '127.0.0.1:0';
    this.process = spawn(leda, [...this.arguments, '--listen', listen], {stdio: ['ignore', 'pipe', 'pipe']});
    this.log = '';
    this.process.stderr.on('data', (text) => (this.log += text));
    this.url = await new Promise((found, failed) => {
      let said = '';
      this.process.stdout.on('data', (text) => {
        said += text;
        const [, url] = /leda serves (\S+)/.exec(said) ?? [];
        if (url) found(url);
      });
      this.process.on('exit', (code) => failed(new Error(`the server ended with ${code}: ${this.log}`)));
    });
  }

  async stop() {
    const ended = new Promise((done) => this.process.once('exit', done));
    this.process.kill('SIGTERM');
    await ended;
  }

  async end() {
    if (this.process.exitCode === null && this.process.signalCode === null) await this.stop();
    rmSync(this.folder, {recursive: true, force: true});
  }

  async ask(method, path, body, type = 'application/json') {
    const headers = body ? {'Content-Type': type} : {};
    if (this.token) headers.Authorization = `Bearer ${this.token}`;
    const answer = await fetch(this.url + path, {method, headers, body});
    assert.ok(answer.ok, `${method} ${path}: ${answer.status} ${answer.ok ? '' : await answer.text()}`);
    return answer.json();
  }

  /** Runs a region, or what another process takes, to its end. @return the job's id */
  async run(request, process = 'map-region') {
    const {jobID} = await this.ask('POST', `/processes/${process}/execution`, JSON.stringify(request));
    for (let i = 0; i < 600; ++i) {
      const {status, message} = await this.ask('GET', `/jobs/${jobID}`);
      if (status === 'successful') return jobID;
      assert.ok(['accepted', 'running'].includes(status), message);
      await new Promise((done) => setTimeout(done, 200));
    }
    throw new Error(`job ${jobID} did not end`);
  }
}

export class Browser {
  static async open({viewport = large, locale = 'en-CA'} = {}) {
    const browser = new Browser();
    browser.program = await chromium.launch({
      executablePath: process.env.LEDA_CHROMIUM ?? '/usr/bin/chromium',
      args: ['--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
        '--disable-background-networking', '--disable-component-update', '--disable-sync'],
    });
    const context = await browser.program.newContext({viewport, locale, acceptDownloads: true});
    browser.page = await context.newPage();
    browser.page.setDefaultTimeout(20_000);
    browser.said = [];
    browser.foreign = [];
    browser.page.on('console', (message) => browser.said.push(`${message.type()}: ${message.text()}`));
    browser.page.on('pageerror', (error) => browser.said.push(`uncaught: ${error.stack}`));
    browser.page.on('request', (request) => {
      const url = new URL(request.url());
      if (url.protocol !== 'blob:' && url.protocol !== 'data:' &&
        url.hostname !== '127.0.0.1') browser.foreign.push(request.url());
    });
    return browser;
  }

  /** Chromium itself says of each answer that is no success that it was none; a test names those it expects. */
  expect_silence(...expected) {
    const words = this.said.filter((line) => !expected.some((pattern) => pattern.test(line)));
    assert.deepEqual(words, [], 'words in the console');
    assert.deepEqual(this.foreign, [], 'requests to another host');
  }

  /** A file that the page hands to the browser. */
  async downloaded(button) {
    const [download] = await Promise.all([this.page.waitForEvent('download'), this.page.click(button)]);
    return {name: download.suggestedFilename(), bytes: readFileSync(await download.path())};
  }

  /** What axe-core finds wrong with what the page shows now. */
  async expect_accessible(where) {
    if (!await this.page.evaluate(() => 'axe' in window)) await this.page.evaluate(axe_source);
    const {violations} = await this.page.evaluate(() => window.axe.run(document, {resultTypes: ['violations']}));
    assert.deepEqual(violations.map(({id,
      nodes}) => `${where}: ${id}: ${nodes.map(({html}) => html.slice(0, 160)).join(' | ')}`), []);
  }

  async picture(name) {
    if (process.env.LEDA_PICTURES) await this.page.screenshot({path: join(process.env.LEDA_PICTURES, `${name}.png`)});
  }

  async step(name) {
    await this.page.click(`nav [data-step=${name}]`);
  }

  async enter_token(token) {
    await this.page.fill('#token', token);
    await this.page.press('#token', 'Enter');
  }

  /** A request brought in as a file, as a user imports one. */
  async import_request(server, request) {
    const file = join(server.folder, 'request.json');
    writeFileSync(file, JSON.stringify(request));
    await this.step('soil');
    await this.page.setInputFiles('.step[data-step=soil] input[type=file]', file);
    await this.page.waitForSelector('fieldset.model');
  }

  async upload(file) {
    await this.page.setInputFiles('.drop input[type=file]', file);
    await this.page.click('text="Upload"');
    await this.page.waitForSelector('.about');
  }

  /** A click on the map at a share of its width and height. */
  async click_map(x, y, count = 1) {
    const box = await this.page.locator('.map').boundingBox();
    await this.page.mouse.click(box.x + x * box.width, box.y + y * box.height, {clickCount: count, delay: 20});
    // Two clicks close together would be taken for a double click, which ends a line.
    await this.page.waitForTimeout(350);
  }

  async close() {
    await this.program.close();
  }
}

/** A browser that looks at a server; it is closed whatever comes. */
export async function with_browser(server, run, options) {
  const browser = await Browser.open(options);
  try {
    await browser.page.goto(server.url);
    await run(browser, browser.page);
  } catch (error) {
    await browser.picture('failed');
    throw error;
  } finally {
    await browser.close();
  }
}
