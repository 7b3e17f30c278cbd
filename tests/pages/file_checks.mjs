// Pages of thousands of files: the figures of all of them, rows that are made when they come into sight.

import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { check, check_equal } from './checks.mjs';

/** So many strips of 1 to 40 quads, whose triangles are in a sequence that can be bettered. */
export function write_strips(folder, count) {
  for (let i = 0; i < count; ++i) {
    const place = path.join(folder, `set${i % 50}`);
    if (i < 50) mkdirSync(place, { recursive: true });
    const quads = 1 + ((i * 7) % 40);
    let text = '';
    for (let x = 0; x <= quads; ++x) text += `v ${x} 0 ${i}\nv ${x} 1 ${i}\n`;
    const faces = [];
    for (let x = 0; x < quads; ++x) {
      const [a, b, c, d] = [2 * x + 1, 2 * x + 2, 2 * x + 3, 2 * x + 4];
      faces.push(`f ${a} ${c} ${d}\n`, `f ${a} ${d} ${b}\n`);
    }
    faces.sort((a, b) => ((a.length * 31 + i) % 7) - ((b.length * 31 + i) % 7));
    for (let x = 0; x < faces.length; x += 3) faces.push(...faces.splice(0, 1));
    writeFileSync(path.join(place, `strip${String(i).padStart(5, '0')}.obj`), text + faces.join(''));
  }
}

const files = (page, member, ...given) => page.evaluate(([m, g]) => window.foredraw.files[m](...g), [member, given]);

/** The table and the histogram say what the JSON says of each file. */
export async function check_files(page, comparison) {
  const count = comparison.files.length;
  const shown = () => page.$$eval('#files tbody tr:not(.space)', (rows) => rows.map((row) => row.cells[0].title));
  check_equal('files: all of them have a row', (await files(page, 'rows')).length, count);
  check('files: of which those in sight are there', (await shown()).length < 100, (await shown()).length);
  check_equal('files: no article for each', (await page.$$('#figures article.file')).length, 1);

  const acmr = comparison.files.map(({ input, metrics }) => {
    const row = metrics.find(({ evaluator, metric }) => evaluator === 'vertex-cache' && metric === 'acmr');
    return { path: input.path, change: (row.values[0] - row.input) / Math.abs(row.input) };
  });
  const changes = new Map(acmr.map(({ path: file, change }) => [file, change]));
  const sorted = (await files(page, 'rows')).map((file) => changes.get(file));
  // Values on the page have six digits.
  const falls = sorted.every((change, i) => i === 0 || sorted[i - 1] > change - 1e-4);
  check('files: the worst first', falls);

  await page.evaluate(() => {
    const scroll = document.querySelector('#files .scroll.rows');
    scroll.scrollTop = scroll.scrollHeight;
  });
  await page.waitForFunction((last) => {
    const rows = document.querySelectorAll('#files tbody tr:not(.space)');
    return rows.length > 0 && rows[rows.length - 1].ariaRowIndex === String(last);
  }, count + 1);
  check_equal('files: the last row is there at the end', (await shown()).at(-1), (await files(page, 'rows')).at(-1));

  const bars = await page.$$eval('#files .bar', (all) => all.map((bar) => parseInt(bar.title, 10)));
  check_equal('files: the bars hold them all', bars.reduce((a, b) => a + b, 0), count);
  const fullest = bars.indexOf(Math.max(...bars));
  await page.locator('#files .bar').nth(fullest).click();
  check_equal('files: a bar leaves its files', (await files(page, 'rows')).length, bars[fullest]);
  await page.locator('#files .bar').nth(fullest).click();
  check_equal('files: pressed again, all', (await files(page, 'rows')).length, count);

  await page.locator('#files .filter input').fill('set7/ 0007');
  const left = await files(page, 'rows');
  check('files: the box leaves those with its words', left.length > 0 && left.length < 50, left.length);
  check_equal('files: and tells how many', await page.textContent('#files .count'), `${left.length} of ${count} files`);
  await page.locator('#files .filter input').fill('');
  await page.locator('#files thead button').first().click();
  const by_name = await files(page, 'rows');
  const compare = new Intl.Collator('en', { numeric: true, sensitivity: 'base' }).compare;
  check('files: sorted by name', by_name.every((file, i) => i === 0 || compare(by_name[i - 1], file) <= 0));
}
