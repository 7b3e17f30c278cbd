// Asks three.js in a browser without a window about models. Each line of the input is {"before": FILE} or
// {"before": FILE, "after": FILE}, each line of the output the answer, in the same sequence:
//
//   {"shows": true, "views": [{"covered": 5311, "differing": 0}, ...]}    `differing` where there is an `after`
//   {"shows": false, "reason": "..."}                                     the loader refused it, or no pixel is drawn
//
// With a folder as argument, pictures that differ are kept in it.

import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { chromium } from 'playwright-core';

const origin = 'https://viewer.invalid';
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm' };
const looks_a_page = 25; // a browser's page keeps what it drew: a new one now and then
const longest = 120_000; // milliseconds for one look
const page_text = `<!doctype html><script type="importmap">{"imports": {"three": "/three/build/three.module.js",
  "three/addons/": "/three/examples/jsm/"}}</script><script type="module" src="/viewer/pictures.mjs"></script>`;

const kept = process.argv[2];
const own = mkdtempSync(join(tmpdir(), 'foredraw-look-'));

function answer(route) {
  const path = decodeURIComponent(new URL(route.request().url()).pathname);
  if (path === '/') return route.fulfill({ contentType: 'text/html', body: page_text });
  const file = path
    .replace(/^\/viewer\//, `${import.meta.dirname}/`)
    .replace(/^\/three\//, `${import.meta.dirname}/node_modules/three/`)
    .replace(/^\/file\//, '/');
  try {
    const body = readFileSync(file);
    return route.fulfill({ contentType: types[extname(file)] ?? 'application/octet-stream', body });
  } catch {
    return route.fulfill({ status: 404, body: '' });
  }
}

/** three.js has no loader for OFF: there, Assimp is the viewer. */
function shown_file(file) {
  if (extname(file).toLowerCase() !== '.off') return file;
  const made = join(own, 'off.stl');
  rmSync(made, { force: true });
  try {
    execFileSync('assimp', ['export', file, made, '-fstlb'], { stdio: 'ignore' });
  } catch {
    throw new Error('Assimp does not read it');
  }
  return made;
}

const address = (file) => `${origin}/file${shown_file(file).split('/').map(encodeURIComponent).join('/')}`;

async function open_page(browser) {
  const page = await browser.newPage();
  await page.route('**/*', answer);
  await page.goto(origin);
  await page.waitForFunction(() => window.look);
  return page;
}

function keep_pictures(found, name) {
  if (!kept) return;
  mkdirSync(kept, { recursive: true });
  for (const [at, view] of found.views.entries())
    for (const [which, data] of Object.entries(view.pictures ?? {}))
      writeFileSync(join(kept, `${name}-${at}-${which}.png`), Buffer.from(data.split(',')[1], 'base64'));
}

const browser = await chromium.launch({
  executablePath: execFileSync('sh', ['-c', 'command -v chromium'], { encoding: 'utf8' }).trim(),
  args: ['--no-sandbox', '--disable-dev-shm-usage', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
let page;
let looks = 0;
for await (const line of createInterface({ input: process.stdin })) {
  const { before, after } = JSON.parse(line);
  let found;
  try {
    if (page && looks % looks_a_page === 0) page = await page.close();
    page ??= await open_page(browser);
    const asked = page.evaluate(
      ([first, second]) => window.look(first, second),
      [address(before), after ? address(after) : null],
    );
    let clock;
    const late = new Promise((_, fail) => (clock = setTimeout(() => fail(new Error('it takes too long')), longest)));
    found = await Promise.race([asked, late]).finally(() => clearTimeout(clock));
    if (found.views) keep_pictures(found, String(looks));
    for (const view of found.views ?? []) delete view.pictures;
  } catch (error) {
    found = { shows: false, reason: String(error.message).split('\n')[0] };
    await page?.close().catch(() => {});
    page = undefined;
  }
  ++looks;
  console.log(JSON.stringify(found));
}
await browser.close();
rmSync(own, { recursive: true });
