// A picture of a page's plot and viewer, for the README: node picture.mjs PAGE.html FILE SUBJECT PICTURE.png
// FILE: the number of the file among those that the viewer has; the first two pipelines stand side by side.

import { launch, open, settled } from './browser.mjs';

const [html, file, subject, picture] = process.argv.slice(2);
const browser = await launch();
const { page } = await open(browser, html, { viewport: { width: 1280, height: 900 }, colorScheme: 'light' });
await page.evaluate(
  async ([scene, number]) => {
    const { viewer } = window.foredraw;
    viewer.set_scene(scene);
    viewer.set_subject(number);
    viewer.set_state(0, 3);
    viewer.set_state(1, 2);
    await viewer.show_worst_view();
  },
  [Number(file), Number(subject)],
);
await settled(page);
await page.waitForTimeout(1500); // until the ratios below the panes stand
const top = await page.$eval('#plot', (section) => section.getBoundingClientRect().top + window.scrollY);
const bottom = await page.$eval('#viewer', (section) => section.getBoundingClientRect().bottom + window.scrollY);
await page.screenshot({ path: picture, fullPage: true, clip: { x: 0, y: top, width: 1280, height: bottom - top } });
await browser.close();
