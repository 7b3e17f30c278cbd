// Levels of detail: what the slider draws and says, and whether anything pops as a level takes the place of another one.

import { settled } from './browser.mjs';
import { check, check_equal, check_near } from './checks.mjs';
import { play_for } from './playing.mjs';
import { content, viewer } from './viewer_checks.mjs';

/** The slider goes through the levels of the second pane, by hand and by keys. `levels`: [number] {triangles}. */
export async function check_levels(page, levels, { step }) {
  const slider = page.locator('#viewer .levels input');
  const words = async () => (await page.textContent('#viewer .levels output')).replaceAll(',', '');
  const coarsest = levels.length - 1;
  check_equal('levels: the slider ends at the coarsest', await slider.getAttribute('max'), String(coarsest));
  for (const [level, { triangles }] of levels.entries()) {
    await slider.evaluate((input, value) => {
      input.value = value;
      input.dispatchEvent(new Event('input'));
    }, level);
    check_equal(`levels: triangles of level ${level}`, await viewer(page, 'triangles', 1), triangles);
    const said = await words();
    const place = level === 0 ? 'full detail' : `level ${level} of ${coarsest}`;
    check(`levels: the slider says ${place}`, said.startsWith(`${place}: ${triangles} triangles`), said);
    check('levels: and how far away that is', /at most [\d.e-]+ away unposed$/.test(said) === level > 0, said);
  }
  await slider.focus();
  await page.keyboard.press('Home');
  check_equal('levels: Home is full detail', await viewer(page, 'level'), 0);
  await page.keyboard.press('ArrowRight');
  check_equal('levels: an arrow is a step', await viewer(page, 'level'), step);
  await page.keyboard.press('End');
  check_equal('levels: End is the coarsest', await viewer(page, 'level'), coarsest);
  check('levels: it is read out', (await slider.getAttribute('aria-valuetext')).startsWith(`level ${coarsest} of`));
  await play_for(page, page.locator('#viewer .levels button'), 3000);
  const stopped = await viewer(page, 'level');
  check('levels: playing goes through them', stopped > 0 && stopped < coarsest, stopped);
  await settled(page);
  check_equal('levels: it plays until it is stopped', await viewer(page, 'level'), stopped);
  await viewer(page, 'set_level', 0);
}

/** No slider where nothing that is shown has levels. */
export async function check_no_levels(page) {
  const slider = page.locator('#viewer .levels input');
  await page.selectOption('#viewer label:has-text("Compare with") select', 'nothing');
  check('levels: no slider for the input, which has none', !(await slider.isVisible()));
  await page.selectOption('#viewer label:has-text("Compare with") select', '1');
  check('levels: a slider for the pipeline that made some', await slider.isVisible());
}

/**
 * Between two pictures of the second pane: the largest step of a pixel, of 255, and the share of pixels that take one.
 * `before`, `after`: levels.
 */
export const picture_step = (page, before, after) =>
  page.evaluate(
    ([from, to]) => {
      const { viewer: shown } = window.foredraw;
      const picture = (level) => {
        shown.set_level(level);
        return shown.picture(1).data;
      };
      const [a, b] = [picture(from), picture(to)];
      let largest = 0;
      let pixels = 0;
      for (let i = 0; i < a.length; i += 4) {
        const step = Math.max(...[0, 1, 2].map((channel) => Math.abs(a[i + channel] - b[i + channel])));
        largest = Math.max(largest, step);
        pixels += step > 0 ? 1 : 0;
      }
      return { largest, share: (4 * pixels) / a.length };
    },
    [before, after],
  );

/** A longer caption below a pane makes it lower, and a picture is drawn where the panes are then. */
async function check_first_picture(page) {
  const changed = await page.evaluate(() => {
    const { viewer: shown } = window.foredraw;
    shown.set_state(1, 1);
    shown.picture(1);
    shown.set_state(1, 2);
    const [first, second] = [shown.picture(1).data, shown.picture(1).data];
    return first.reduce((sum, value, i) => sum + (value === second[i] ? 0 : 1), 0);
  });
  check_equal('pops: the first picture of a state is the one that stays', changed, 0);
}

const almost = 1 - 2 ** -40; // of the way to the next level: as floats, all of it

/** Over all switches of the second pane, in some poses and from two sides: as picture_step() has it, the most of each. */
export async function largest_pop(page, coarsest) {
  await viewer(page, 'set_mode', 'shaded');
  const poses = (await viewer(page, 'poses')).length;
  const most = { largest: 0, share: 0 };
  for (const pose of [0, Math.floor(poses / 2), poses - 1]) {
    await viewer(page, 'set_pose', pose);
    for (const direction of [
      [0.48, 0.36, 0.8],
      [-0.8, 0.1, -0.6],
    ]) {
      await viewer(page, 'set_direction', direction);
      for (let level = 0; level < coarsest; ++level) {
        const step = await picture_step(page, level + almost, level + 1);
        most.largest = Math.max(most.largest, step.largest);
        most.share = Math.max(most.share, step.share);
      }
    }
  }
  return most;
}

const as_text = ({ largest, share }) => `${largest} of 255, ${(100 * share).toFixed(4)} % of the pixels`;

/** State 1 has levels, and state 2 the same and what vertices become. */
export async function check_pops(page, name, coarsest) {
  await check_first_picture(page);
  await viewer(page, 'set_state', 1, 1);
  const without = await largest_pop(page, coarsest);
  await viewer(page, 'set_state', 1, 2);
  const smooth = await largest_pop(page, coarsest);
  console.log(`      ${name}: largest step of a pixel at a switch ${as_text(smooth)}; without geomorphs ${as_text(without)}`);
  check(`pops: ${name}, none with geomorphs`, smooth.largest <= 2, smooth);
  check(`pops: ${name}, seen without`, without.largest > 64 && without.share > 0.02, without);
}

/**
 * What is told in colours is what surface-error measures between a draw and its original, each way: at points, so no more
 * of it than is proved.
 */
export async function check_deviation(page, comparison) {
  const error = comparison.files[0].branches[0].report.totals.metrics['surface-error'];
  await viewer(page, 'set_state', 1, 1);
  await viewer(page, 'set_mode', 'deviation');
  await settled(page);
  const remarks = await page.$$eval('#viewer .order', (all) => all.map(({ textContent }) => textContent));
  const seen = [await viewer(page, 'deviation', 0), await viewer(page, 'deviation', 1)];
  for (const [pane, way, other] of [
    [0, 'from-original', 'the other surface'],
    [1, 'to-original', 'the input'],
  ]) {
    const [most, found] = [error[way].largest.numerator, error[way].found.numerator];
    check(
      `deviation: the largest distance is that of surface-error, ${way}`,
      seen[pane] <= most * (1 + 1e-6) && seen[pane] > 0.8 * found,
      [seen[pane], found, most],
    );
    const said = remarks[pane].match(/^up to ([\d.e-]+) away from (.*)$/);
    check_near('deviation: the caption tells it', Number(said?.[1]), seen[pane], 0.01);
    check_equal('deviation: and from where', said?.[2], other);
  }
  const bounds = await page.$$eval('#viewer .swatch', (all) =>
    all.map((one) => Number(one.textContent.match(/[\d.e-]+$/))),
  );
  const largest = Math.max(...seen);
  check_equal('deviation: the legend has eight colours', bounds.length, 8);
  check('deviation: which hold the largest distance', bounds[6] < 2 * largest && largest <= 2 * bounds[7], [bounds, seen]);
  const state = await content(page, 1);
  check('deviation: what is away is yellow and red', state.warm > 0.05 * state.drawn, state);
  await viewer(page, 'set_drawn', 0);
  check_equal('deviation: drawn up to a triangle as well', (await content(page, 1)).drawn, 0);
  await viewer(page, 'set_drawn', Infinity);
  await viewer(page, 'set_state', 1, null);
  const input = await content(page, 0);
  check('deviation: the input alone is blue', input.drawn > 0 && input.warm === 0, input);
  check_equal('deviation: and nowhere away', await viewer(page, 'deviation', 0), 0);
  await viewer(page, 'set_mode', 'heat');
}
