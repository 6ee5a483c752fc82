// Bundles the unit tests, which are TypeScript, and runs them: node run.mjs FOLDER

import {spawnSync} from 'node:child_process';
import {mkdirSync, readdirSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = fileURLToPath(new URL('.', import.meta.url));
const page = fileURLToPath(new URL('../../../server/page/', import.meta.url));
const {buildSync} = createRequire(join(page, 'package.json'))('esbuild');
const [out] = process.argv.slice(2);
mkdirSync(out, {recursive: true});

const checked = spawnSync(process.execPath, [join(page, 'node_modules/typescript/bin/tsc'), '--noEmit', '-p', page],
  {stdio: 'inherit'});
if (checked.status !== 0) process.exit(1);

const tests = readdirSync(here).filter((file) => file.endsWith('_test.ts'));
buildSync({
  entryPoints: tests.map((file) => join(here, file)), outdir: out, outExtension: {'.js': '.mjs'}, bundle: true,
  platform: 'node', format: 'esm', nodePaths: [join(page, 'node_modules')], logLevel: 'error',
  // What a browser has and the modules under test look at when they are loaded.
  banner: {js: [
    "globalThis.document ??= {baseURI: 'http://127.0.0.1/'};",
    "globalThis.navigator ??= {language: 'en'};",
    'globalThis.localStorage ??= {getItem: () => null, setItem() {}};',
  ].join('')},
});
const files = tests.map((file) => join(out, file.replace(/ts$/, 'mjs')));
process.exit(spawnSync(process.execPath, ['--test', ...files], {stdio: 'inherit', env: {...process.env,
  LEDA_SOURCE: join(here, '../../..')}}).status);
