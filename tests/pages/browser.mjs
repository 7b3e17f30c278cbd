// A browser without a window and without a network.

import { execFileSync } from 'node:child_process';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const flags = [
  '--no-sandbox',
  '--disable-dev-shm-usage',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
const software_gl = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

export async function launch({ has_gl = true } = {}) {
  const executablePath = execFileSync('sh', ['-c', 'command -v chromium'], { encoding: 'utf8' }).trim();
  return chromium.launch({ executablePath, args: [...flags, ...(has_gl ? software_gl : ['--disable-3d-apis'])] });
}

/**
 * Opens a page from its file. `complaints` gathers what the console says and what is thrown, `requests` all that is
 * asked for beside the file itself.
 */
export async function open(browser, file, { viewport = { width: 1280, height: 900 }, ...options } = {}) {
  const page = await browser.newPage({ viewport, ...options });
  page.setDefaultTimeout(300_000); // a busy machine without a GPU takes its time
  const address = pathToFileURL(file).href;
  const complaints = [];
  const requests = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.stack));
  page.on('request', (request) => {
    if (request.url() !== address) requests.push(request.url());
  });
  await page.goto(address);
  if (options.javaScriptEnabled !== false) await page.evaluate(() => window.foredraw.viewer.ready);
  return { page, complaints, requests };
}

/** As wide as a window of that size makes it, which takes a moment. */
export async function set_width(page, width) {
  await page.setViewportSize({ width, height: 900 });
  await page.waitForFunction((wanted) => window.innerWidth === wanted, width);
  await settled(page);
}

/** Until what was asked for stands in a frame. */
export const settled = (page) =>
  page.evaluate(
    () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done)))),
  );
