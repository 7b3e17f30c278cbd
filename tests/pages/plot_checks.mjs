// The plot: its axes, its points, its front and what hovering tells.

import { check, check_equal } from './checks.mjs';
import { settled } from './browser.mjs';

/** Who is beaten by nobody, from the JSON and by the definition. */
function front_of(points) {
  return points
    .filter(([, x, y]) => !points.some(([, ox, oy]) => ox <= x && oy <= y && (ox < x || oy < y)))
    .map(([place]) => place);
}

/** [place, value] of a figure, place 0 for the input and i + 1 for branch i. */
function values_of(file, key) {
  if (key === 'time') return [null, ...file.branches.map((branch) => 1000 * branch.seconds)];
  const row = file.metrics.find(({ evaluator, metric }) => `${evaluator} ${metric}` === key);
  return [row.input, ...row.values];
}

export async function check_plot(page, comparison) {
  const [file] = comparison.files;
  const plot = (name, ...given) =>
    page.evaluate(([called, args]) => window.foredraw.plot[called](...args), [name, given]);
  check_equal('plot: time and overdraw to begin with', await plot('chosen'), ['time', 'overdraw-raster ratio']);

  const pairs = [
    ['time', 'overdraw-raster ratio'],
    ['vertex-cache acmr', 'overdraw-raster ratio'],
    ['vertex-cache atvr', 'time'],
  ];
  for (const [x, y] of pairs) {
    await page.selectOption('#plot select >> nth=' + ((await page.locator('#plot select').count()) - 2), x);
    await page.selectOption('#plot select >> nth=' + ((await page.locator('#plot select').count()) - 1), y);
    const [xs, ys] = [values_of(file, x), values_of(file, y)];
    const expected = xs.flatMap((value, place) =>
      value !== null && ys[place] !== null ? [[place, value, ys[place]]] : [],
    );
    const points = await plot('points');
    check(
      `plot: the points over ${x} and ${y}`,
      points.length === expected.length &&
        points.every(
          ([place, px, py], i) =>
            place === expected[i][0] && Math.abs(px - expected[i][1]) < 1e-9 && Math.abs(py - expected[i][2]) < 1e-9,
        ),
      points,
    );
    check_equal(
      `plot: the front over ${x} and ${y}`,
      await plot('front'),
      front_of(expected.filter(([place]) => place > 0)),
    );
    const said = await page.textContent('#plot .front');
    check(
      `plot: the front is told in words`,
      (await plot('front')).every((place) => said.includes(`[${place}]`)),
      said,
    );
  }

  await plot('set_axes', 'time', 'overdraw-raster ratio');
  await page.locator('#plot .chart').scrollIntoViewIfNeeded();
  const box = await page.locator('#plot canvas').boundingBox();
  for (const [place, x, y] of (await plot('positions')).slice(0, 2)) {
    await page.mouse.move(box.x + x, box.y + y);
    await settled(page);
    const lines = (await plot('tooltip')).join('\n');
    check(
      `plot: the tooltip of [${place}] has its name and its figures`,
      lines.includes(`[${place}]`) &&
        lines.includes('time') &&
        lines.includes(values_of(file, 'overdraw-raster ratio')[place].toFixed(4)),
      lines,
    );
  }
  await page.mouse.move(1, 1);
  await settled(page);
  check_equal('plot: no tooltip without the pointer', await plot('tooltip'), []);

  const before = await plot('positions');
  await page.check('#plot input[type=checkbox]');
  const after = await plot('positions');
  check(
    'plot: a logarithmic axis moves the points',
    before.some(([, x], i) => Math.abs(x - after[i][1]) > 5),
    [before, after],
  );
  await page.uncheck('#plot input[type=checkbox]');
}
