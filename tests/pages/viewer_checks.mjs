// The viewer: something is to be seen in every mode, triangles are drawn in the state's sequence, tables switch orders.

import { readFileSync } from 'node:fs';
import { settled } from './browser.mjs';
import { check, check_equal, check_near } from './checks.mjs';
import { play_for } from './playing.mjs';

/** Calls the page's own interface. */
export const viewer = (page, name, ...given) =>
  page.evaluate(
    async ([called, args]) => {
      const answer = await window.foredraw.viewer[called](...args);
      return ArrayBuffer.isView(answer) ? Array.from(answer) : answer;
    },
    [name, given],
  );

/** How many pixels of a pane differ from its corner, how many are more red than blue, and how many colours it has. */
export const content = (page, pane) =>
  page.evaluate((number) => {
    const { data } = window.foredraw.viewer.picture(number);
    const words = new Uint32Array(data.buffer);
    return {
      pixels: words.length,
      drawn: words.filter((word) => word !== words[0]).length,
      warm: words.filter((_, i) => data[4 * i] > data[4 * i + 2]).length,
      colours: new Set(words).size,
    };
  }, pane);

/** Until every pane is drawn and tells the ratio of what it shows: its captions no longer move it. */
export async function counted(page) {
  await settled(page);
  await page.waitForFunction(() => !document.querySelector('#viewer figure:not([hidden]) .stale'));
}

export async function check_modes(page) {
  for (const [mode, least_colours] of [
    ['heat', 2],
    ['shaded', 20],
    ['order', 20],
    ['clusters', 20],
    ['deviation', 20],
  ]) {
    await viewer(page, 'set_mode', mode);
    const { pixels, drawn, colours } = await content(page, 0);
    check(
      `viewer: ${mode} is not blank`,
      drawn > 0.1 * pixels && drawn < 0.95 * pixels,
      `${drawn} of ${pixels} pixels`,
    );
    check(`viewer: ${mode} has its colours`, colours >= least_colours, colours);
  }
  for (const is_orthographic of [false, true]) {
    await viewer(page, 'set_orthographic', is_orthographic);
    check(
      `viewer: not blank, ${is_orthographic ? 'orthographic' : 'in perspective'}`,
      (await content(page, 0)).drawn > 0,
    );
  }
  await viewer(page, 'set_mode', 'heat');
}

export async function check_panes(page) {
  await viewer(page, 'set_state', 1, null);
  await settled(page);
  const figures = page.locator('#viewer figure');
  check('panes: one alone', (await figures.nth(0).isVisible()) && !(await figures.nth(1).isVisible()));
  await page.selectOption('#viewer label:has-text("Compare with") select', '1');
  await settled(page);
  check('panes: two', (await figures.nth(0).isVisible()) && (await figures.nth(1).isVisible()));
  check('panes: the second is not blank', (await content(page, 1)).drawn > 0);
  check_equal('panes: named', await figures.nth(0).locator('strong').textContent(), 'input');
  await counted(page);
  for (const pane of [0, 1]) {
    const { ratio } = await viewer(page, 'overdraw', pane);
    check_equal(
      `panes: the ratio of pane ${pane}`,
      await figures.nth(pane).locator('.ratio').textContent(),
      `${ratio.toFixed(3)} fragments per pixel`,
    );
  }
}

/** The first n triangles of branch 0 are those that the program's own table of what went where has first. */
export async function check_drawn(page, remap, pipeline) {
  await viewer(page, 'set_state', 0, 1);
  const all = await viewer(page, 'triangles');
  const order = remap.flatMap((draw) => draw ?? Array.from({ length: all }, (_, i) => i));
  check_equal(`slider: all triangles after ${pipeline}`, await viewer(page, 'drawn_triangles', 0), order);

  const slider = page.locator('#viewer .slider input').first();
  let last = -1;
  for (const part of [0, 0.1, 0.5, 1]) {
    const n = Math.round(part * all);
    await slider.evaluate((input, value) => {
      input.value = value;
      input.dispatchEvent(new Event('input'));
    }, n);
    check_equal(`slider: the first ${n} triangles`, await viewer(page, 'drawn_triangles', 0), order.slice(0, n));
    const shaded = (await viewer(page, 'overdraw', 0)).shaded;
    check(
      `slider: ${n} triangles shade more pixels than fewer did`,
      n === 0 ? shaded === 0 : shaded > last,
      `${shaded} after ${last}`,
    );
    last = shaded;
  }
  const words = (await page.textContent('#viewer .slider output')).replaceAll(',', '');
  check_equal('slider: says how many', words, `triangles drawn: ${all} of ${all}`);

  await play_for(page, page.locator('#viewer .slider button').first(), 1000);
  const drawn = (await viewer(page, 'drawn_triangles', 0)).length;
  check('slider: playing draws them one after the other', drawn > 0 && drawn < all, drawn);
  await viewer(page, 'set_drawn', all);
  await viewer(page, 'set_state', 0, 0);
}

export async function check_keyboard(page) {
  await page.locator('#viewer .window').first().focus();
  const start = await viewer(page, 'direction');
  await page.keyboard.press('ArrowRight');
  const right = await viewer(page, 'direction');
  check(
    'keyboard: an arrow turns the camera to the right',
    right[0] > start[0] && Math.abs(right[1] - start[1]) < 1e-9,
    right,
  );
  await page.keyboard.press('ArrowUp');
  const up = await viewer(page, 'direction');
  check('keyboard: an arrow turns it upwards', up[1] > right[1], up);
  await page.keyboard.press('Home');
  const near = (a, b) => a.every((value, axis) => Math.abs(value - b[axis]) < 1e-9);
  check('keyboard: Home brings it back', near(await viewer(page, 'direction'), start));
  const before = (await content(page, 0)).drawn;
  await page.keyboard.press('-');
  check('keyboard: minus zooms out', (await content(page, 0)).drawn < before);
  await page.keyboard.press('+');
  await counted(page);
  await page.locator('#viewer .window').first().hover();
  const box = await page.locator('#viewer .window').first().boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2);
  await page.mouse.up();
  check('mouse: dragging turns the camera', !near(await viewer(page, 'direction'), start));
  await viewer(page, 'set_direction', start);
}

/** The evaluator looks from the same 100 directions. */
export async function check_worst_view(page, comparison) {
  await page.click('#viewer button:has-text("Worst view")');
  await page.waitForFunction(() =>
    [...document.querySelectorAll('#viewer button')].some((b) => b.textContent === 'Worst view'),
  );
  const { ratio } = await viewer(page, 'overdraw', 0);
  const { input } = comparison.files[0].metrics.find(({ metric }) => metric === 'worst-view');
  check_near('worst view: that of the figures', ratio, input, 0.01);

  // What is chosen while it looks must not break it.
  await page.click('#viewer button:has-text("Worst view")');
  await viewer(page, 'set_subject', 0);
  await viewer(page, 'set_state', 1, null);
  await page.waitForFunction(() => document.querySelector('#viewer .buttons button:disabled') === null);
  await viewer(page, 'set_state', 1, 1);
}

/** Of two states with different numbers of triangles each is drawn to its own end. */
export async function check_unlike_states(page) {
  await viewer(page, 'set_state', 0, 0);
  await viewer(page, 'set_state', 1, 2);
  const [fewer, more] = [await viewer(page, 'triangles', 0), await viewer(page, 'triangles', 1)];
  check('states: the second has more triangles', fewer < more, [fewer, more]);
  const drawn = async () => [
    (await viewer(page, 'drawn_triangles', 0)).length,
    (await viewer(page, 'drawn_triangles', 1)).length,
  ];
  const said = async () => (await page.textContent('#viewer .slider output')).replaceAll(',', '');
  for (const [n, expected] of [
    [fewer - 1, [fewer - 1, fewer - 1]],
    [fewer + 1, [fewer, fewer + 1]],
    [more, [fewer, more]],
  ]) {
    await viewer(page, 'set_drawn', n);
    check_equal(`states: up to triangle ${n}`, await drawn(), expected);
    check_equal(
      `states: the slider at ${n} says how many`,
      await said(),
      `triangles drawn: ${expected[0]} of ${fewer} and ${expected[1]} of ${more}`,
    );
  }
  await viewer(page, 'set_state', 0, 2);
  check_equal('states: what was drawn whole stays whole', await drawn(), [more, more]);
}

/** The order that a table has for a pose and a direction, looked up anew from the page's JSON. */
function order_of(table, pose, [x, y, z]) {
  let first = 0;
  for (const { name, times } of table.clips) {
    if (name === pose.clip) {
      const distances = times.map((time) => Math.abs(time - pose.time));
      first += distances.indexOf(Math.min(...distances));
      const [theta, phi] = [Math.acos(y / Math.hypot(x, y, z)) / Math.PI, Math.atan2(z, x) / (2 * Math.PI) + 0.5];
      const cell = Math.floor(theta * table['theta-steps']) * table['phi-steps'] + Math.floor(phi * table['phi-steps']);
      return table.order[first * table['theta-steps'] * table['phi-steps'] + cell];
    }
    first += times.length;
  }
  return 0;
}

/** Orders of an animated character follow the camera and the pose. */
export async function check_table(page, html, scenes) {
  const [subject] = scenes[0].subjects;
  const { geometry, orders, table } = subject.states[1];
  const { parts } = subject.geometries[geometry];
  check('table: the character has several orders', table !== null && orders.length > 1, orders.length);
  const pieces = readFileSync(html, 'utf8').matchAll(/class="buffer-0">([^<]*)</g);
  const buffer = Buffer.from(Array.from(pieces, ([, base64]) => base64).join(''), 'base64');
  const triangles_of = (k) => {
    let first = 0;
    return parts.flatMap((part, i) => {
      const from = orders[k][i].triangles;
      const numbers = Array.from({ length: part.triangles }, (_, t) => first + buffer.readUInt32LE(from + 4 * t));
      first += part.triangles;
      return numbers;
    });
  };
  await viewer(page, 'set_state', 0, 1);
  const wrong = [];
  const used = new Set();
  const poses = [0, Math.floor(subject.poses.length / 2), subject.poses.length - 1];
  for (const pose of poses) {
    await viewer(page, 'set_pose', pose);
    for (let i = 0; i < 24; ++i) {
      const direction = [Math.cos(i * 2.4), (2 * i + 1) / 24 - 1, Math.sin(i * 2.4)];
      await viewer(page, 'set_direction', direction);
      const k = await viewer(page, 'order_of', 0);
      used.add(k);
      const expected = order_of(table, subject.poses[pose], direction);
      if (k !== expected) wrong.push(`pose ${pose}, direction ${direction}: ${k}, should be ${expected}`);
    }
  }
  check(`table: the order of ${24 * poses.length} views is the table's`, wrong.length === 0, wrong);
  check('table: several orders are drawn', used.size > 1, [...used]);
  for (const k of used) {
    const look = await page.evaluate(async (wanted) => {
      const { viewer: shown } = window.foredraw;
      for (let i = 0; i < 400 && shown.order_of(0) !== wanted; ++i) {
        if (i % 100 === 0) shown.set_pose(Math.floor((i / 400) * shown.poses().length));
        shown.set_direction([Math.cos(i * 2.4), ((i % 100) + 0.5) / 50 - 1, Math.sin(i * 2.4)]);
      }
      return shown.order_of(0);
    }, k);
    if (look !== k) continue;
    check_equal(`table: the triangles of order ${k}`, await viewer(page, 'drawn_triangles', 0), triangles_of(k));
    await settled(page);
    const said = await page.textContent('#viewer .order');
    check(`table: the caption tells order ${k + 1}`, said.startsWith(`order ${k + 1} of ${orders.length}`), said);
  }
}

/** Poses follow the slider and, while it plays, the clock. */
export async function check_poses(page) {
  const slider = page.locator('#viewer .poses .slider input');
  await viewer(page, 'set_pose', 0);
  const before = await viewer(page, 'pixel_counts', 0, 64);
  await slider.evaluate((input) => {
    input.value = Math.floor(Number(input.max) / 2);
    input.dispatchEvent(new Event('input'));
  });
  const after = await viewer(page, 'pixel_counts', 0, 64);
  check(
    'poses: another pose is another picture',
    before.some((count, i) => count !== after[i]),
  );
  const text = () => page.textContent('#viewer .poses .slider output');
  const was = await text();
  await play_for(page, page.locator('#viewer .poses .slider button'), 500);
  const stopped = await text();
  check('poses: playing goes on to others', stopped !== was, stopped);
  await settled(page);
  check_equal('poses: nothing moves when it does not play', await text(), stopped);
}
