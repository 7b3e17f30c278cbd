// Corners and colours of triangles in the sequence in which they are drawn.

import { cluster_colour, ramp } from './colours.js';

/** Three corners for each triangle of the order, brought into the sphere of radius 1 at the origin. */
export function fill_corners(corners, positions, indices, order, [cx, cy, cz], radius) {
  const scale = 1 / radius;
  let to = 0;
  for (let place = 0; place < order.length; ++place) {
    const triangle = 3 * order[place];
    for (let corner = triangle; corner < triangle + 3; ++corner) {
      const from = 3 * indices[corner];
      corners[to++] = (positions[from] - cx) * scale;
      corners[to++] = (positions[from + 1] - cy) * scale;
      corners[to++] = (positions[from + 2] - cz) * scale;
    }
  }
}

/** The same colour for all corners of a triangle: words of bytes r g b 255, lowest byte first. */
function fill_triangle(words, place, [r, g, b]) {
  words.fill(
    (Math.round(r) | (Math.round(g) << 8) | (Math.round(b) << 16) | (255 << 24)) >>> 0,
    3 * place,
    3 * place + 3,
  );
}

/** By place among all triangles of the state, of which this part's begin at `first`. */
export function fill_order_colours(words, triangles, first, all) {
  const steps = 256;
  const colours = Array.from({ length: steps }, (_, i) => ramp(i / (steps - 1)));
  for (let place = 0; place < triangles; ++place) {
    fill_triangle(words, place, colours[Math.floor(((first + place) / all) * steps)]);
  }
}

/** By cluster; without clusters the part is one. `first_cluster` keeps neighbouring parts apart. */
export function fill_cluster_colours(words, triangles, offsets, first_cluster) {
  const ends = offsets ?? [0, triangles];
  for (let cluster = 0; cluster + 1 < ends.length; ++cluster) {
    const colour = cluster_colour(first_cluster + cluster);
    for (let place = ends[cluster]; place < ends[cluster + 1]; ++place) fill_triangle(words, place, colour);
  }
}
