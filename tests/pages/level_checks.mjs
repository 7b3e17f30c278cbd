// Levels of detail: what the slider draws and says, and whether anything pops as a level takes the place of another one.

import { settled } from './browser.mjs';
import { check, check_equal } from './checks.mjs';
import { viewer } from './viewer_checks.mjs';

/** The slider goes through the levels of the second pane, by hand and by keys. `levels`: [number] {triangles}. */
export async function check_levels(page, levels, { step }) {
  const slider = page.locator('#viewer .levels input');
  const words = async () => (await page.textContent('#viewer .levels output')).replaceAll(',', '');
  const coarsest = levels.length - 1;
  check_equal('levels: the slider ends at the coarsest', await slider.getAttribute('max'), String(coarsest));
  check_equal('levels: its steps', await slider.getAttribute('step'), String(step));
  for (const [level, { triangles }] of levels.entries()) {
    await slider.evaluate((input, value) => {
      input.value = value;
      input.dispatchEvent(new Event('input'));
    }, level);
    check_equal(`levels: triangles of level ${level}`, await viewer(page, 'triangles', 1), triangles);
    const said = await words();
    const place = level === 0 ? 'full detail' : `level ${level} of ${coarsest}`;
    check(`levels: it says ${place}`, said.startsWith(`${place}: ${triangles} triangles`), said);
    check(`levels: and how far away that is`, level === 0 || /at most [\d.e-]+ away$/.test(said), said);
  }
  await slider.focus();
  await page.keyboard.press('Home');
  check_equal('levels: Home is full detail', await viewer(page, 'level'), 0);
  await page.keyboard.press('ArrowRight');
  check_equal('levels: an arrow is a step', await viewer(page, 'level'), step);
  await page.keyboard.press('End');
  check_equal('levels: End is the coarsest', await viewer(page, 'level'), coarsest);
  check_equal('levels: it is read out', await slider.getAttribute('aria-valuetext'), await page.textContent('#viewer .levels output'));
  await page.click('#viewer .levels button');
  await page.waitForFunction(() => window.foredraw.viewer.level() > 0);
  await page.click('#viewer .levels button');
  check('levels: it plays', (await viewer(page, 'level')) <= coarsest);
  await page.selectOption('#viewer label:has-text("Compare with") select', 'nothing');
  check('levels: no slider where nothing that is shown has any', !(await slider.isVisible()));
  await page.selectOption('#viewer label:has-text("Compare with") select', '1');
  await viewer(page, 'set_level', 0);
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

const almost = 1 - 2 ** -24; // of the way to the next level: all vertices have arrived, to the bit or the one before

/** The largest step of a pixel at any switch, over some poses and directions. */
export async function largest_pop(page, coarsest) {
  await viewer(page, 'set_mode', 'shaded');
  const poses = (await viewer(page, 'poses')).length;
  let [largest, share] = [0, 0];
  for (const pose of [0, Math.floor(poses / 2), poses - 1]) {
    await viewer(page, 'set_pose', pose);
    for (const direction of [[0.48, 0.36, 0.8], [-0.8, 0.1, -0.6]]) {
      await viewer(page, 'set_direction', direction);
      for (let level = 0; level < coarsest; ++level) {
        const step = await picture_step(page, level + almost, level + 1);
        [largest, share] = [Math.max(largest, step.largest), Math.max(share, step.share)];
      }
    }
  }
  return { largest, share };
}
