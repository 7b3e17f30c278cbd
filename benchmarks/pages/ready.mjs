// When pages are ready after they were opened: node ready.mjs PROGRAM OUTPUT_FOLDER, in the build folder of tests/pages,
// which has the browser's driver. Beside each stands a bare page of the same size, for machines differ.

import { statSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const here = (name) => import(pathToFileURL(path.resolve(name)).href);
const { launch } = await here('browser.mjs');
const { write_strips } = await here('file_checks.mjs');
const { torus, write_gltf } = await here('models.mjs');
const { Program } = await here('program.mjs');

const [program_path, folder] = process.argv.slice(2);
const program = new Program(program_path, folder);
const browser = await launch();

/** Milliseconds by the page's own clock until it sets the mark. */
async function ready(file, mark) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction((name) => performance.getEntriesByName(name).length > 0, mark);
  const time = await page.evaluate((name) => performance.getEntriesByName(name)[0].startTime, mark);
  await page.close();
  return time;
}

/** Both are loaded one after the other, so that a busy machine is busy for both. */
async function print_times(what, html, mark, work) {
  const bare = path.join(folder, `bare-${path.basename(html)}`);
  const text = 'A'.repeat(statSync(html).size);
  const script = `${work} performance.mark('${mark}');`;
  writeFileSync(bare, `<!doctype html><script type="text/plain">${text}</script><script>${script}</script>`);
  console.log(`${what}: ms until it is ready, and of a bare page`);
  for (let i = 0; i < 5; ++i) {
    const [ours, its] = [await ready(html, mark), await ready(bare, mark)];
    console.log(`  ${ours.toFixed(0)} / ${its.toFixed(0)} = ${(ours / its).toFixed(2)}`);
  }
}

const large = write_gltf(path.join(folder, 'large.gltf'), [{ name: 'torus', ...torus(320, 160) }]);
const sizes = [8, 10, 12, 14, 16, 20, 24, 32];
const pipelines = sizes.map((size) => `tipsify(cache-size=${size})`);
const of_states = program.compare('large', [large], pipelines, { more: ['--with', 'vertex-cache'] });
const picture =
  "const gl = document.createElement('canvas').getContext('webgl2'); gl.clear(gl.COLOR_BUFFER_BIT); gl.finish();";
await print_times('102,400 triangles in 9 states', of_states.html, 'viewer-ready', picture);

const strips = path.join(folder, 'strips');
write_strips(strips, 5000);
const more = ['--with', 'vertex-cache, scene-cost'];
const of_files = program.compare('strips', [strips], ['tipsify', 'weld, forsyth'], { more });
await print_times('5,000 files', of_files.html, 'files-ready', '');

await browser.close();
