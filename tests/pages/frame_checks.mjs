// The section of films and charts: what the evaluator "walk" (walk.cpp) attaches, and the slider that moves it all.

import path from 'node:path';
import { set_width, settled } from './browser.mjs';
import { check, check_equal, check_near } from './checks.mjs';
import { hold_frames, play_for } from './playing.mjs';

const frames = (page, name, ...given) =>
  page.evaluate(([called, args]) => window.foredraw.frames[called](...args), [name, given]);

/** What the report tells of a chart in a state: place 0 is the input, i + 1 branch i. */
function chart_of(comparison, file, place, name) {
  const [first] = comparison.files[file].branches;
  const branch = place === 0 ? first : comparison.files[file].branches[place - 1];
  const measure = branch.report.measures.find(({ use }) => use === 'walk');
  return (place === 0 ? measure.before : measure).attachments.find((one) => one.name === name);
}

/** [r, g, b] in the middle of each picture of an element, as it is shown. */
const colours_of = (page, selector) =>
  page.$$eval(selector, (images) =>
    Promise.all(images.map(async (image) => {
      await image.decode();
      const canvas = document.createElement('canvas');
      [canvas.width, canvas.height] = [1, 1];
      const context = canvas.getContext('2d');
      context.drawImage(image, image.naturalWidth / 2, image.naturalHeight / 2, 1, 1, 0, 0, 1, 1);
      return [...context.getImageData(0, 0, 1, 1).data.slice(0, 3)];
    })),
  );

/** The part of a chart's column at x, or of its row at y, that has the colour of a custom property. */
const part_coloured = (page, chart, { x, y }, property) =>
  page.evaluate(
    ([number, at, name]) => {
      const canvas = document.querySelectorAll('#frames canvas')[number];
      const probe = document.createElement('span');
      probe.style.color = `var(${name})`;
      document.body.append(probe);
      const wanted = getComputedStyle(probe).color.match(/[\d.]+/g).map(Number);
      probe.remove();
      const scale = canvas.width / canvas.clientWidth;
      const copy = document.createElement('canvas');
      [copy.width, copy.height] = [canvas.width, canvas.height];
      const context = copy.getContext('2d', { willReadFrequently: true });
      context.drawImage(canvas, 0, 0);
      const part = (line) => {
        const pixels =
          at.x === undefined
            ? context.getImageData(0, line, canvas.width, 1).data
            : context.getImageData(line, 0, 1, canvas.height).data;
        let found = 0;
        for (let i = 0; i < pixels.length; i += 4) {
          if ([0, 1, 2].every((c) => Math.abs(pixels[i + c] - wanted[c]) < 24) && pixels[i + 3] > 200) ++found;
        }
        return (4 * found) / pixels.length;
      };
      const near = Math.round((at.x ?? at.y) * scale);
      return Math.max(part(near - 1), part(near), part(near + 1));
    },
    [chart, { x, y }, property],
  );

const slider = (page, group = 0) => page.locator('#frames .frames').nth(group).locator('.slider');

async function check_frame(page, comparison, states, at) {
  const what = `frames: at frame ${at + 1}`;
  check_equal(`${what}, the slider says so`, await slider(page).locator('output').textContent(), `frame ${at + 1} of 24`);
  const films = await colours_of(page, '#frames .frames >> nth=0 >> .film img');
  const expected = Array(states).fill([[10 * at, 10 * at, 10 * at], [10 * at, 0, 40]]).flat();
  check_equal(`${what}, every film shows its picture`, films, expected);
  for (let place = 0; place < states; ++place) {
    const { lines, unit } = chart_of(comparison, 0, place, 'cost');
    const texts = await page.locator('#frames .state').nth(place).locator('.curves >> nth=0').locator('.value').allTextContents();
    lines.forEach(({ values }, i) => {
      const value = values[at];
      if (value === null) check_equal(`${what}, a gap is told`, texts[i], '-');
      else check_near(`${what}, the value of line ${i} in state ${place}`, Number.parseFloat(texts[i]), value, 0.01);
      check(`${what}, with its unit`, value === null || texts[i].endsWith(` ${unit}`), texts[i]);
    });
    check_equal(`${what}, the budget is told`, texts.at(-1), '10.00 ms');
  }
}

/** The part of a column that a line from the top of the plane to its bottom has. */
const least_of_line = 0.6;

async function check_lines_at(page, charts, at, before) {
  for (let chart = 0; chart < charts; ++chart) {
    const column = async (frame) => {
      const [x] = await frames(page, 'position', 0, chart, frame, 0);
      return part_coloured(page, chart, { x }, '--ink');
    };
    const [now, then] = [await column(at), await column(before)];
    check(`frames: chart ${chart} has its line at frame ${at + 1}`, now > least_of_line, now);
    check(`frames: chart ${chart} has no line at frame ${before + 1}`, then < 0.2, then);
  }
}

async function check_slider(page, comparison, states) {
  const charts = 2 * states;
  const range = slider(page).locator('input');
  check_equal('frames: the slider has a name', await range.getAttribute('aria-label'), 'Frame of walk');
  await check_frame(page, comparison, states, 0);
  await check_lines_at(page, charts, 0, 4);
  await range.focus();
  for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowRight');
  await settled(page);
  await check_frame(page, comparison, states, 4);
  await check_lines_at(page, charts, 4, 0);
  check_equal('frames: the slider is told in words', await range.getAttribute('aria-valuetext'), 'frame 5 of 24');
  const alt = await page.getAttribute('#frames .film img >> nth=0', 'alt');
  check_equal('frames: pictures are told in words', alt, 'steady, frame 5 of 24');
  for (let i = 4; i < 10; ++i) await page.keyboard.press('ArrowRight');
  await settled(page);
  await check_frame(page, comparison, states, 10);
}

async function check_charts(page, comparison, states) {
  await frames(page, 'set_frame', 0, 20);
  const [, mark] = await frames(page, 'position', 0, 0, 0, 10);
  const dashed = await part_coloured(page, 0, { y: mark }, '--ink-soft');
  check('frames: the mark is a dashed line', dashed > 0.3 && dashed < 0.75, dashed);
  const [, elsewhere] = await frames(page, 'position', 0, 0, 0, 12);
  const beside = await part_coloured(page, 0, { y: elsewhere }, '--ink-soft');
  check('frames: no line where no mark is', beside < 0.1, beside);
  const heights = [];
  for (let state = 0; state < states; ++state) heights.push((await frames(page, 'position', 0, 2 * state, 0, 5))[1]);
  check('frames: charts of one name have one scale', Math.max(...heights) - Math.min(...heights) < 1, heights);

  const canvas = page.locator('#frames canvas').first();
  const [x, y] = await frames(page, 'position', 0, 0, 15, 10);
  await canvas.hover({ position: { x, y } });
  await settled(page);
  const told = (await frames(page, 'tooltip', 0, 0)).join('\n');
  const { values } = chart_of(comparison, 0, 0, 'cost').lines[1];
  const is_whole = told.includes('frame 16 of 24') && told.includes(`<b>eager</b>: ${values[15].toFixed(2)} ms`);
  check('frames: hovering tells a frame and its values', is_whole && told.includes('budget: 10.00 ms'), told);
  await canvas.click({ position: { x, y } });
  await page.waitForFunction(() => window.foredraw.frames.frame(0) !== 20);
  check_equal('frames: a click moves the slider', await frames(page, 'frame', 0), 15);
  await page.mouse.move(1, 1);
}

async function check_playing(page) {
  const play = slider(page).locator('button');
  check_equal('frames: the button says what it plays', await play.getAttribute('aria-label'), 'Play: the frames of walk');
  await frames(page, 'set_frame', 0, 23);
  await play_for(page, play, 2000);
  const stopped = await frames(page, 'frame', 0);
  check('frames: it plays from the first frame again', stopped > 3 && stopped < 20, stopped);
  await settled(page);
  check_equal('frames: it stands where it was stopped', await frames(page, 'frame', 0), stopped);
  const film = await hold_frames(page);
  await play.press('Enter');
  check_equal('frames: the button stops it', await play.textContent(), 'Pause');
  await film.show(10_000);
  check_equal('frames: the button plays it again', await play.textContent(), 'Play');
  await film.let_go();
  check_equal('frames: it ends at the last frame', await frames(page, 'frame', 0), 23);
}

/** Of several pipelines, one below the other, by name. */
export async function check_frames(page, comparison, folder) {
  const { branches } = comparison.files[0];
  const names = ['input', ...branches.map(({ name }, i) => `[${i + 1}] ${name}`)];
  const heads = await page.locator('#frames .frames').first().locator('h4').allTextContents();
  check_equal('frames: every state stands below its name', heads, names);
  check_equal('frames: a technique is named', await page.textContent('#frames h3'), 'walk');
  check_equal('frames: names are no markup', await page.locator('#frames b').count(), 0);
  await check_slider(page, comparison, names.length);
  await check_charts(page, comparison, names.length);
  await check_playing(page);

  check('frames: one picture needs no slider', await slider(page, 1).isHidden());
  const portraits = await colours_of(page, '#frames .frames >> nth=1 >> img');
  check_equal('frames: it is shown of every state', portraits, names.map(() => [9, 200, 9]));
  const portrait = page.locator('#frames .frames').nth(1).locator('.film').first();
  check('frames: it says of which draw it is', /portrait on \S.*once/.test(await portrait.textContent()));
  const width = await portrait.locator('img').evaluate((image) => image.clientWidth);
  check_equal('frames: it is shown pixel by pixel', width, 300);

  await frames(page, 'set_frame', 0, 6);
  await page.emulateMedia({ colorScheme: 'dark' });
  await settled(page);
  await check_lines_at(page, 2, 6, 0);
  await page.locator('#frames').screenshot({ path: path.join(folder, 'frames-dark.png') });
  await page.emulateMedia({ colorScheme: 'light' });
  await settled(page);
  await page.locator('#frames').screenshot({ path: path.join(folder, 'frames-light.png') });
  await set_width(page, 360);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth);
  check('frames: nothing sticks out at 360', wide <= 360, wide);
}

/** One of several files is shown. */
export async function check_frames_of_files(page, comparison) {
  const costs = async () => Number.parseFloat(await page.textContent('#frames .value'));
  for (const file of [0, 1, 0]) {
    await page.selectOption('#frames label:has-text("File") select', String(file));
    const { values } = chart_of(comparison, file, 0, 'cost').lines[0];
    check_near(`frames: the values of file ${file}`, await costs(), values[0], 0.01);
    check_equal(`frames: it begins at the first frame of file ${file}`, await frames(page, 'frame', 0), 0);
  }
}

export async function check_no_frames(page) {
  check_equal('frames: no section where nothing is attached', await page.locator('#frames').count(), 0);
  check_equal('frames: nor a link to it', await page.locator('nav a[href="#frames"]').count(), 0);
}
