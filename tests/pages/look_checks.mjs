// How the page looks: colours, widths, without scripts, without WebGL, on paper.

import path from 'node:path';
import { launch, open, set_width, settled } from './browser.mjs';
import { check, check_equal } from './checks.mjs';

/** [red, green, blue] of what an element's property shows. */
const colour = (page, selector, property) =>
  page.$eval(
    selector,
    (element, name) =>
      getComputedStyle(element)
        [name].match(/[\d.]+/g)
        .map(Number)
        .slice(0, 3),
    property,
  );

const luminance = (rgb) =>
  rgb
    .map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4))
    .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);

function contrast(a, b) {
  const [light, dark] = [luminance(a), luminance(b)].sort((x, y) => y - x);
  return (light + 0.05) / (dark + 0.05);
}

/** What a custom property of the style sheet stands for. */
const property = (page, name) =>
  page.evaluate((wanted) => {
    const probe = document.createElement('span');
    probe.style.color = `var(${wanted})`;
    document.body.append(probe);
    const rgb = getComputedStyle(probe)
      .color.match(/[\d.]+/g)
      .map(Number)
      .slice(0, 3);
    probe.remove();
    return rgb;
  }, name);

async function check_contrast(page, theme) {
  const low = [];
  for (const ground of ['--paper', '--raised', '--highlight']) {
    for (const ink of ['--ink', '--ink-soft', '--accent', '--better', '--worse']) {
      const ratio = contrast(await property(page, ink), await property(page, ground));
      if (ratio < 4.5) low.push(`${ink} on ${ground}: ${ratio.toFixed(2)}`);
    }
  }
  check(`colours: ${theme}, texts stand out`, low.length === 0, low);
}

export async function check_colours(page, folder) {
  const is_dark = async () => luminance(await colour(page, 'body', 'backgroundColor')) < 0.1;
  const picture = (name) => page.screenshot({ path: path.join(folder, name), fullPage: true });
  await page.emulateMedia({ colorScheme: 'light' });
  check('colours: light where the system is', !(await is_dark()));
  await check_contrast(page, 'light');
  await settled(page);
  await picture('page-light-1280.png');
  await page.emulateMedia({ colorScheme: 'dark' });
  check('colours: dark where the system is', await is_dark());
  await check_contrast(page, 'dark');
  await settled(page);
  await picture('page-dark-1280.png');
  await page.click('button.theme');
  check('colours: the button makes it light', !(await is_dark()));
  await page.emulateMedia({ colorScheme: 'light' });
  await page.click('button.theme');
  check('colours: the button makes it dark', await is_dark());
  await page.click('button.theme');
  check('colours: the button gives it back to the system', !(await is_dark()));
}

export async function check_widths(page, folder) {
  for (const width of [360, 768, 1280, 2560]) {
    await set_width(page, width);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    check(`widths: nothing sticks out at ${width}`, wide <= width, wide);
    const cut = await page.$$eval(
      '#viewer .window',
      (windows) =>
        windows
          .map((window) => window.getBoundingClientRect())
          .filter(({ left, right, height }) => height > 0 && (left < 0 || right > innerWidth)).length,
    );
    check_equal(`widths: panes are whole at ${width}`, cut, 0);
    if (width === 360) await page.screenshot({ path: path.join(folder, 'page-360.png'), fullPage: true });
  }
  await set_width(page, 1280);
}

export async function check_paper(page) {
  await page.emulateMedia({ media: 'print' });
  const shown = await page.$$eval(
    '#viewer .controls, #viewer .slider, body > nav',
    (all) => all.filter((one) => one.offsetParent !== null).length,
  );
  check_equal('paper: no controls', shown, 0);
  await page.emulateMedia({ media: 'screen' });
}

export async function check_without_script(browser, html) {
  const { page, complaints } = await open(browser, html, { javaScriptEnabled: false });
  check('without scripts: the figures are there', (await page.locator('#figures tbody tr').count()) > 0);
  check('without scripts: it says what is missing', await page.locator('#viewer .without-script').isVisible());
  check('without scripts: the pipelines can be opened', (await page.locator('#pipelines details').count()) > 0);
  check('without scripts: no complaint but that', complaints.length === 0, complaints);
  await page.close();
}

export async function check_without_gl(html) {
  const browser = await launch({ has_gl: false });
  const { page } = await open(browser, html);
  check('without WebGL: it says so', (await page.textContent('#viewer')).includes('not support WebGL 2'));
  check('without WebGL: the plot works', (await page.evaluate(() => window.foredraw.plot.points().length)) > 0);
  await page.click('#figures th button >> nth=0');
  check_equal(
    'without WebGL: tables are sorted',
    await page.getAttribute('#figures th >> nth=0', 'aria-sort'),
    'ascending',
  );
  await browser.close();
}
