// Bundles the map page and writes its files as C++: node bundle.mjs OUT.cpp
import {createHash} from 'node:crypto';
import {existsSync, readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {gzipSync} from 'node:zlib';
import {build} from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const [out] = process.argv.slice(2);
if (!out) throw new Error('usage: node bundle.mjs OUT.cpp');

const bundled = await build({
  absWorkingDir: here,
  entryPoints: {page: 'src/main.ts'},
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2020',
  legalComments: 'none',
  metafile: true,
  write: false,
  outdir: '.',
  logLevel: 'warning',
});

// Licences of the packages whose code is in the bundle.
function licences() {
  const packages = new Set();
  for (const file of Object.keys(bundled.metafile.inputs)) {
    const found = /node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file);
    if (found) packages.add(found[1]);
  }
  return [...packages].sort().map((name) => {
    const folder = join(here, 'node_modules', name);
    const about = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    const file = readdirSync(folder).find((f) => /^licen[cs]e/i.test(f));
    const text = file ? readFileSync(join(folder, file), 'utf8') : `Licence: ${about.license}\n`;
    return `${name} ${about.version}\n\n${text.trim()}\n`;
  }).join('\n----\n\n');
}

const files = [
  {name: 'index.html', type: 'text/html; charset=utf-8', bytes: readFileSync(join(here, 'src/index.html'))},
  {name: 'icon.svg', type: 'image/svg+xml', bytes: readFileSync(join(here, 'src/icon.svg'))},
  {name: 'licences.txt', type: 'text/plain; charset=utf-8', bytes: Buffer.from(licences())},
];
for (const file of bundled.outputFiles) {
  const script = file.path.endsWith('.js');
  const type = script ? 'text/javascript; charset=utf-8' : 'text/css; charset=utf-8';
  files.push({name: script ? 'page.js' : 'page.css', type, bytes: Buffer.from(file.contents)});
}

// A string literal; octal escapes have at most three digits, so that no digit after one is drawn in.
function literal(bytes) {
  let text = '';
  const lines = [];
  for (const byte of bytes) {
    const plain = byte >= 0x20 && byte < 0x7f && byte !== 0x22 && byte !== 0x5c && byte !== 0x3f;
    text += plain ? String.fromCharCode(byte) : '\\' + byte.toString(8).padStart(3, '0');
    if (text.length > 4000) {
      lines.push(`"${text}"`);
      text = '';
    }
  }
  lines.push(`"${text}"`);
  return lines.join('\n');
}

let packedBytes = 0;
const rows = files.map(({name, type, bytes}) => {
  const gzip = gzipSync(bytes, {level: 9});
  packedBytes += gzip.length;
  const hash = createHash('sha256').update(bytes).digest('hex').slice(0, 16);
  const view = (data) => `std::string_view(${literal(data)},\n${data.length})`;
  return `PageFile{"${name}", "${type}", "${hash}",\n${view(bytes)},\n${view(gzip)}}`;
});
const text = `// Made by bundle.mjs.
#include <array>

#include "server/page/page_files.hpp"

namespace leda::server {

std::span<const PageFile> page_files() {
  static const std::array files{
${rows.join(',\n')}};
  return files;
}

}  // namespace leda::server
`;
if (!existsSync(out) || readFileSync(out, 'utf8') !== text) writeFileSync(out, text);
console.log(`map page: ${files.length} files, ${packedBytes} bytes packed`);
