// Makes one C++ source of the page's script: node bundle.mjs OUTPUT.cpp
// The packages of package-lock.json must be installed beside this file.

import { build } from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const piece_bytes = 16000; // compilers limit the length of a literal

const folder = path.dirname(fileURLToPath(import.meta.url));

/// Every copy of the packages must carry these.
function licences() {
  return ['three/LICENSE', 'chart.js/LICENSE.md', '@kurkle/color/LICENSE.md']
    .map((file) => `/*! ${file}\n${readFileSync(path.join(folder, 'node_modules', file), 'utf8').trim()}\n*/`)
    .join('\n');
}

async function bundled() {
  const result = await build({
    absWorkingDir: folder,
    entryPoints: ['script/page.js'],
    bundle: true,
    minify: true,
    format: 'iife',
    target: 'es2022',
    legalComments: 'eof',
    footer: { js: licences() },
    write: false,
  });
  return result.outputFiles[0].text;
}

/// What would end the script element too early, or keep it open.
function check(script) {
  for (const text of ['</script', '<!--']) {
    if (script.toLowerCase().includes(text)) throw new Error(`the script must not hold ${text}`);
  }
}

/// Pieces of whole UTF-8 characters.
function pieces_of(script) {
  const bytes = Buffer.from(script);
  const pieces = [];
  for (let begin = 0; begin < bytes.length;) {
    let end = Math.min(begin + piece_bytes, bytes.length);
    while (end < bytes.length && (bytes[end] & 0xc0) === 0x80) --end;
    pieces.push(bytes.subarray(begin, end).toString());
    begin = end;
  }
  return pieces;
}

/// What may stand between R" and ( and does not occur in the text.
function delimiter_for(script) {
  for (let i = 0; ; ++i) {
    const delimiter = `js${i}`;
    if (!script.includes(`)${delimiter}"`)) return delimiter;
  }
}

function cpp_of(script) {
  const delimiter = delimiter_for(script);
  const literals = pieces_of(script).map((piece) => `    R"${delimiter}(${piece})${delimiter}"`);
  return `// Made by framework/foredraw/page/bundle.mjs.
#include <foredraw/page/private/page_assets.h>

namespace foredraw {

namespace {

constexpr char script[] =
${literals.join('\n')};

}  // namespace

std::string_view page_script() { return {script, sizeof script - 1}; }

}  // namespace foredraw
`;
}

const [output] = process.argv.slice(2);
if (!output) throw new Error('usage: node bundle.mjs OUTPUT.cpp');
const script = await bundled();
check(script);
writeFileSync(output, cpp_of(script));
console.log(`${path.basename(output)}: a script of ${Buffer.byteLength(script)} bytes`);
