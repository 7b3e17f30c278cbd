// Tables: the figures of the JSON, sorting, filtering, and a branch that stands out.

import { check, check_equal } from './checks.mjs';

const cells_of = (page, table) =>
  page.$$eval(`${table} tbody tr`, (rows) =>
    rows.map((row) =>
      [...row.cells].map((cell) => ({ text: cell.textContent.trim(), value: cell.dataset.value ?? null })),
    ),
  );

/** Every figure of every file, and of all as one, is the JSON's. */
export async function check_figures(page, comparison) {
  const articles = await page.$$('#figures article.file');
  const keys = await Promise.all(articles.map((article) => article.getAttribute('data-file')));
  const expected_keys = comparison.files.map((_, i) => String(i));
  check_equal('figures: a table for each file', keys, comparison.all ? ['all', ...expected_keys] : expected_keys);
  for (const [place_on_page, article] of articles.entries()) {
    const i = keys[place_on_page];
    const rows = await article.$$eval('tbody tr', (all) =>
      all.map((row) =>
        [...row.cells].map((cell) => ({ text: cell.textContent.trim(), value: cell.dataset.value ?? null })),
      ),
    );
    const { metrics, branches } = i === 'all' ? comparison.all : comparison.files[i];
    const wrong = [];
    let compared = 0;
    for (const [evaluator, metric, , ...cells] of rows) {
      const row = metrics.find((one) => one.evaluator === evaluator.text && one.metric === metric.text);
      const values = row
        ? [row.input, ...row.values]
        : evaluator.text === 'time'
          ? [null, ...branches.map((b) => b.seconds)]
          : null;
      if (values === null || values.length !== cells.length) {
        wrong.push(`${evaluator.text} ${metric.text}: no such row in the JSON`);
        continue;
      }
      cells.forEach((cell, place) => {
        ++compared;
        const is = cell.value === null ? null : Number(cell.value);
        if (is !== values[place])
          wrong.push(`${evaluator.text} ${metric.text} [${place}]: ${is}, should be ${values[place]}`);
      });
    }
    check(
      `figures: all ${compared} cells of file ${i} are those of the JSON`,
      compared > 0 && wrong.length === 0,
      wrong,
    );
    const missing = metrics.filter(
      ({ evaluator, metric }) =>
        !metric.includes('.') && !rows.some(([a, b]) => a.text === evaluator && b.text === metric),
    );
    check(`figures: no figure of file ${i} is missing`, missing.length === 0, missing);
  }
}

/** Up, down, and back to how it came; what holds no figure is last both ways. */
export async function check_sorting(page) {
  const table = '#figures article.file:first-of-type table';
  const column = await page.$$eval(`${table} thead th`, (heads) =>
    heads.findIndex((head) => head.textContent === 'input'),
  );
  const button = page.locator(`${table} thead th`).nth(column).locator('button');
  const values = async () =>
    (await cells_of(page, table)).map((row) => row[column].value).map((v) => (v === null ? null : Number(v)));
  const came = await values();
  const present = came.filter((value) => value !== null);
  const missing = came.filter((value) => value === null);
  const ascending = [...[...present].sort((a, b) => a - b), ...missing];
  const descending = [...[...present].sort((a, b) => b - a), ...missing];

  await button.focus();
  await page.keyboard.press('Enter');
  check_equal('sorting: ascending, by keyboard', await values(), ascending);
  check_equal(
    'sorting: the head says so',
    await page.getAttribute(`${table} thead th:nth-child(${column + 1})`, 'aria-sort'),
    'ascending',
  );
  await button.click();
  check_equal('sorting: descending', await values(), descending);
  await button.click();
  check_equal('sorting: back to how it came', await values(), came);

  const text = page.locator(`${table} thead th`).nth(0).locator('button');
  const names = async () => (await cells_of(page, table)).map(([evaluator, metric]) => [evaluator.text, metric.text]);
  const before = await names();
  await text.click();
  await text.click();
  const compare = new Intl.Collator('en', { numeric: true, sensitivity: 'base' }).compare;
  check_equal(
    'sorting: text, the last first, equal ones as they came',
    await names(),
    [...before].sort((a, b) => compare(b[0], a[0])),
  );
  await text.click();
}

/** A long table has a box that filters it. */
export async function check_filter(page, table) {
  const count = () => page.$$eval(`${table} tbody tr`, (rows) => rows.filter((row) => !row.hidden).length);
  const all = await count();
  const box = page.locator('.filter input').first();
  await box.fill('acmr');
  const some = await count();
  check('filter: leaves the rows with that text', some > 0 && some < all, `${some} of ${all}`);
  await box.fill('');
  check_equal('filter: empty, it shows all', await count(), all);
}

/** A branch's columns stand out while its head is hovered. */
export async function check_highlight(page) {
  const table = '#figures article.file:first-of-type table';
  const background = (branch) =>
    page.$eval(`${table} tbody td[data-branch="${branch}"]`, (cell) => getComputedStyle(cell).backgroundColor);
  await page.mouse.move(1, 1);
  const before = await background(1);
  await page.hover(`${table} thead th[data-branch="1"]`);
  const hovered = await background(1);
  check('highlight: the column of the head that is hovered', hovered !== before, hovered);
  check_equal('highlight: no other column', await background(0), before);
  await page.mouse.move(1, 1);
  await page.focus('#plot .legend button[data-branch="1"]');
  check_equal('highlight: the column of the legend entry that has the focus', await background(1), hovered);
  await page.focus('button.theme');
  check_equal('highlight: gone with the focus', await background(1), before);
}

/** Branches of one file are not those of another. */
export async function check_highlight_of_one_file(page) {
  const background = (file) =>
    page.$eval(
      `#figures [data-file="${file}"] tbody td[data-branch="1"]`,
      (cell) => getComputedStyle(cell).backgroundColor,
    );
  const before = await background('0');
  await page.hover('#figures [data-file="1"] thead th[data-branch="1"]');
  check('highlight: the column in its file', (await background('1')) !== before);
  check_equal('highlight: not that of another file', await background('0'), before);
}
