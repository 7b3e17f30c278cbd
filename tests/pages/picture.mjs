// A picture of a page's plot and viewer, as the README has one: node picture.mjs PAGE.html FILE SUBJECT PICTURE.png
// FILE: the number of the file among those that the viewer has. The third pipeline stands beside the second.

import { launch, open } from './browser.mjs';
import { counted } from './viewer_checks.mjs';

const [html, file, subject, picture] = process.argv.slice(2);
const browser = await launch();
const { page } = await open(browser, html, { viewport: { width: 1280, height: 800 }, colorScheme: 'light' });
await page.addStyleTag({ content: 'body > :is(header, nav), main > section:not(#plot, #viewer) { display: none !important }' });
await page.evaluate(
  ([scene, number]) => {
    const { viewer } = window.foredraw;
    viewer.set_scene(scene);
    viewer.set_subject(number);
    viewer.set_state(0, 3);
    viewer.set_state(1, 2);
    viewer.set_direction([0.75, 0.4, 0.55]);
  },
  [Number(file), Number(subject)],
);
await counted(page);
await page.screenshot({ path: picture, fullPage: true });
await browser.close();
