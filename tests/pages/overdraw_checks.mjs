// The heat map counts what Foredraw counts: by reason on a few rectangles, by its own figure on a real model.

import path from 'node:path';
import { check, check_equal, check_near } from './checks.mjs';
import { rectangles, write_gltf } from './models.mjs';
import { viewer } from './viewer_checks.mjs';

const size = 64;
const full = [-1, -1, 1, 1];
const depths = [-0.5, 0, 0.5];
const quarter = [-1, -1, 0, 0, 0.75]; // nearest of all, over the lower left
const radius = Math.hypot(1, 1, (0.75 + 0.5) / 2);

/** Models: the same rectangles far to near, near to far, and far to near with both sides to be seen. */
export function write_stacks(folder) {
  const far_to_near = rectangles(...depths.map((z) => [...full, z]), quarter);
  const near_to_far = rectangles(quarter, ...depths.toReversed().map((z) => [...full, z]));
  const name = 'stack';
  return [
    write_gltf(path.join(folder, 'far-to-near.gltf'), [{ name, ...far_to_near }]),
    write_gltf(path.join(folder, 'near-to-far.gltf'), [{ name, ...near_to_far }]),
    write_gltf(path.join(folder, 'both-sides.gltf'), [{ name, ...far_to_near }], { doubleSided: true }),
  ];
}

/** The count at a point of the picture, right and up from the middle in the model's units. */
const count_at = (counts, right, up) => {
  const pixel = (along) => Math.floor(((along / radius + 1) / 2) * size);
  return counts[pixel(up) * size + pixel(right)];
};

async function check_counts(page, name, scene, direction, expected) {
  await viewer(page, 'set_scene', scene);
  await viewer(page, 'set_state', 1, null);
  await viewer(page, 'set_direction', direction);
  const counts = await viewer(page, 'pixel_counts', 0, size);
  const points = [
    [-0.5, -0.5],
    [0.5, -0.5],
    [-0.5, 0.5],
    [0.5, 0.5],
    [1.1, 0],
  ];
  check_equal(
    `counts: ${name}`,
    points.map((point) => count_at(counts, ...point)),
    expected,
  );
  return counts;
}

export async function check_stacks(page) {
  const counts = await check_counts(page, 'far to near', 0, [0, 0, 1], [4, 3, 3, 3, 0]);
  check(
    'counts: as many pixels as the rectangles cover',
    Math.abs(counts.filter((n) => n > 0).length - (size / radius) ** 2) < (4 * size) / radius,
  );
  await check_counts(page, 'near to far', 1, [0, 0, 1], [1, 1, 1, 1, 0]);
  await check_counts(page, 'back faces are not drawn', 0, [0, 0, -1], [0, 0, 0, 0, 0]);
  // Seen from behind, left is right: the farthest rectangle, drawn first, is now the nearest.
  await check_counts(page, 'from behind, both sides', 2, [0, 0, -1], [1, 1, 1, 1, 0]);
  await check_counts(page, 'from before, both sides', 2, [0, 0, 1], [4, 3, 3, 3, 0]);

  // Three triangles: the farthest rectangle, and the lower right half of the next.
  await viewer(page, 'set_scene', 0);
  await viewer(page, 'set_direction', [0, 0, 1]);
  await viewer(page, 'set_drawn', 3);
  const three = await viewer(page, 'pixel_counts', 0, size);
  check_equal(
    'counts: the first three triangles',
    [
      [0.5, -0.5],
      [-0.5, 0.5],
      [0.9, -0.9],
    ].map((point) => count_at(three, ...point)),
    [2, 1, 2],
  );
}

/** From a few directions, over all subjects: the state that the page shows, and the file that holds the same. */
export async function check_ratios(page, program, model, { subjects, state = 0 }) {
  const away = [];
  for (const direction of [
    [0, 0, 1],
    [1, 0, 0],
    [0.48, 0.6, 0.64],
    [-0.7, -0.1, 0.7],
    [0, 1, 0],
  ]) {
    let [shaded, visible] = [0, 0];
    for (let subject = 0; subject < subjects; ++subject) {
      if (subjects > 1) await viewer(page, 'set_subject', subject);
      await viewer(page, 'set_state', 0, state);
      await viewer(page, 'set_direction', direction);
      const seen = await viewer(page, 'overdraw', 0);
      shaded += seen.shaded;
      visible += seen.visible;
    }
    const { value, numerator, denominator } = program.overdraw(model, direction).ratio;
    const name = `${path.basename(model)} from ${direction}`;
    check_near(`ratio: ${name}`, shaded / visible, value, 0.005);
    check_near(`ratio: pixels of ${name}`, visible, denominator, 0.01);
    away.push(Math.abs(shaded - numerator) / numerator);
  }
  console.log(
    `      ${path.basename(model)}: fragments within ${(100 * Math.max(...away)).toFixed(2)} % of the program's`,
  );
}

/** The evaluator's views, each in a slice of equal area. */
function fibonacci(count) {
  return Array.from({ length: count }, (_, i) => {
    const y = 1 - (2 * i + 1) / count;
    const ring = Math.sqrt(1 - y * y);
    const phi = i * Math.PI * (3 - Math.sqrt(5));
    return [ring * Math.cos(phi), y, ring * Math.sin(phi)];
  });
}

/** What a pane counts from all the views of the evaluator, over all subjects, is the figure of the page's own table. */
export async function check_table_ratios(page, { metrics }, { subjects, directions }) {
  const row = metrics.find(({ evaluator, metric }) => evaluator === 'overdraw-raster' && metric === 'ratio');
  for (const [state, expected] of [row.input, ...row.values].entries()) {
    const ratio = await page.evaluate(
      async ([shown_state, views, count]) => {
        const { viewer: shown } = window.foredraw;
        let [shaded, visible] = [0, 0];
        for (let subject = 0; subject < count; ++subject) {
          shown.set_subject(subject);
          shown.set_state(1, null);
          shown.set_state(0, shown_state);
          for (const direction of views) {
            shown.set_direction(direction);
            const seen = await shown.overdraw(0);
            shaded += seen.shaded;
            visible += seen.visible;
          }
        }
        return shaded / visible;
      },
      [state, fibonacci(directions), subjects],
    );
    check_near(`ratio: state ${state} from ${directions} directions is that of the table`, ratio, expected, 0.005);
  }
}

/**
 * Single poses of a character, whose pictures just hold it in each of them. Where its surfaces lie closer together than
 * depths are rounded, the browser's device decides as it likes: `tolerance` is then wider.
 */
export async function check_pose_ratios(page, program, model, poses, { state = 0, tolerance = 0.005 } = {}) {
  const direction = [0.48, 0.6, 0.64];
  const ratios = program.overdraw(model, direction, `, poses=${poses.length}`).poses;
  await viewer(page, 'set_state', 0, state);
  await viewer(page, 'set_direction', direction);
  for (const part of [0, 0.3, 0.6, 0.9]) {
    const pose = Math.floor(part * poses.length);
    await viewer(page, 'set_pose', pose);
    const { ratio, visible } = await viewer(page, 'overdraw', 0);
    const { value, denominator } = ratios[poses[pose].name].ratio;
    const name = `${poses[pose].name} of ${path.basename(model)}`;
    check_near(`ratio: ${name}`, ratio, value, tolerance);
    check_near(`ratio: pixels of ${name}`, visible, denominator, 0.01);
  }
}
