// Wires in the viewer: they are whole where the triangles alone break up, hold their ink, and flicker less.

import { check } from './checks.mjs';
import { viewer } from './viewer_checks.mjs';

/**
 * What the panes show beside the truth, which is the mean of many pictures of the input that slide within a pixel:
 * {errors, flickers, inks, broken}, each for the input's picture and the second pane's. Broken: of the pixels where the
 * truth has something thin, those with less than half of its contrast.
 */
const beside_the_truth = (page, samples) =>
  page.evaluate(async (count) => {
    const { viewer } = window.foredraw;
    const radical = (i) => Array.from({ length: 16 }, (_, bit) => ((i >> bit) & 1) / 2 ** (bit + 1)).reduce((a, b) => a + b);
    // Of the middle channel, from 0 to 1.
    const picture = (pane, right, down) => {
      viewer.set_slide(right, down);
      const { width, height, data } = viewer.picture(pane);
      return { width, height, values: Float64Array.from({ length: width * height }, (_, i) => data[4 * i + 1] / 255) };
    };
    const truth = (right, down) => {
      const sum = picture(0, right, down);
      sum.values.fill(0);
      for (let i = 0; i < count; ++i) {
        const one = picture(0, right + (i + 0.5) / count - 0.5, down + radical(i) - 0.5);
        one.values.forEach((value, pixel) => (sum.values[pixel] += value / count));
      }
      return sum;
    };
    const [before, after] = [
      [0, 0],
      [0.37, 0.21],
    ];
    const truths = [truth(...before), truth(...after)];
    const pictures = [0, 1].map((pane) => [picture(pane, ...before), picture(pane, ...after)]);
    viewer.set_slide(0, 0);
    const { width, height } = truths[0];
    const root = (f) => Math.sqrt(truths[0].values.reduce((sum, _, i) => sum + f(i) ** 2, 0) / (width * height));
    const ground = truths[0].values[0];
    const ink = ({ values }) => values.reduce((sum, value) => sum + Math.abs(value - ground), 0);
    const contrast = ({ values }, x, y) => {
      let [least, most] = [Infinity, -Infinity];
      for (const row of [y - 1, y, y + 1]) {
        for (const column of [x - 1, x, x + 1]) {
          least = Math.min(least, values[row * width + column]);
          most = Math.max(most, values[row * width + column]);
        }
      }
      return most - least;
    };
    const broken = (picture) => {
      let [all, few] = [0, 0];
      for (let y = 1; y + 1 < height; ++y) {
        for (let x = 1; x + 1 < width; ++x) {
          const wanted = contrast(truths[0], x, y);
          if (Math.abs(truths[0].values[y * width + x] - ground) < 0.02 || wanted < 0.03) continue;
          ++all;
          if (contrast(picture, x, y) < wanted / 2) ++few;
        }
      }
      return few / Math.max(1, all);
    };
    return {
      errors: pictures.map(([first]) => root((i) => first.values[i] - truths[0].values[i])),
      flickers: pictures.map(([first, second]) =>
        root((i) => second.values[i] - first.values[i] - (truths[1].values[i] - truths[0].values[i])),
      ),
      inks: pictures.map(([first]) => ink(first) / ink(truths[0]) - 1),
      broken: pictures.map(([first]) => broken(first)),
    };
  }, samples);

async function check_whole(page, name, { error, flicker, ink, broken }) {
  await viewer(page, 'set_mode', 'shaded');
  const found = await beside_the_truth(page, 32);
  const shares = { error: found.errors[1] / found.errors[0], flicker: found.flickers[1] / found.flickers[0] };
  console.log(`      ${name}: ${JSON.stringify({ ...shares, inks: found.inks, broken: found.broken })}`);
  check(`${name}: error beside the triangles' alone`, shares.error <= error, shares.error);
  check(`${name}: flicker`, shares.flicker <= flicker, shares.flicker);
  check(`${name}: ink`, Math.abs(found.inks[1]) <= ink, found.inks);
  check(`${name}: not broken`, found.broken[1] <= broken * found.broken[0], found.broken);
}

/**
 * Thin tubes of nodes that scale, unevenly and mirrored too. The device rounds corners to 1/16 pixel, so facets of a tenth
 * have about their light: ink is not nearer to the truth than that.
 */
export async function check_thin_tubes(page) {
  for (const is_orthographic of [true, false]) {
    await viewer(page, 'set_orthographic', is_orthographic);
    await viewer(page, 'set_direction', [0.3, 0.4, 1]);
    const name = `wires: tubes, ${is_orthographic ? 'orthographic' : 'in perspective'}`;
    await check_whole(page, name, { error: 0.3, flicker: 0.2, ink: 0.15, broken: 0.1 });
  }
  const told = await page.textContent('#viewer');
  check('wires: the legend says how they are drawn', told.includes('wires in [1] wire-radius: by'), told);
}

/** The rigging of the ship. */
export async function check_rigging(page) {
  await viewer(page, 'set_direction', [0.3, 0.2, 0.9]);
  await check_whole(page, 'wires: the ship', { error: 0.75, flicker: 0.65, ink: 0.05, broken: 0.7 });
}
