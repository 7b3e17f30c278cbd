// How far a state's surface is from another one, point by point: vertices alone would not do, for a simplifier may leave
// each of them where it was.

const small_triangles = 40_000; // about so many in all, where a state has fewer
const most_steps = 24;

const subdivisions = new Map();

/** Barycentric coordinates of a triangle's points, and the corners of the small triangles among them. */
function subdivided(steps) {
  if (subdivisions.has(steps)) return subdivisions.get(steps);
  const points = [];
  const corners = [];
  const first_of_row = (u) => u * (steps + 1) - (u * (u - 1)) / 2;
  for (let u = 0; u <= steps; ++u) {
    for (let v = 0; v <= steps - u; ++v) {
      const [here, above] = [first_of_row(u) + v, first_of_row(u + 1) + v];
      points.push([u / steps, v / steps]);
      if (u + v < steps) corners.push(here, above, here + 1);
      if (u + v + 1 < steps) corners.push(above, above + 1, here + 1);
    }
  }
  subdivisions.set(steps, { points, corners });
  return subdivisions.get(steps);
}

/** The square of each triangle's longest edge, in the sequence of drawing. */
function squared_edges(order, indices, at) {
  const square = (p, q) => [0, 1, 2].reduce((sum, axis) => sum + (at[3 * p + axis] - at[3 * q + axis]) ** 2, 0);
  return Float64Array.from(order, (triangle) => {
    const [a, b, c] = indices.subarray(3 * triangle, 3 * triangle + 3);
    return Math.max(square(a, b), square(b, c), square(c, a));
  });
}

/**
 * The triangles of a part, each divided into `steps` along its edges: corners and distances of the small ones, how many
 * of those are of the first n triangles, and the distances of their own corners.
 */
function divided_part({ order, indices, at, steps }, surface) {
  const ends = new Uint32Array(order.length + 1);
  steps.forEach((of_edge, place) => {
    ends[place + 1] = ends[place] + of_edge ** 2;
  });
  const corners = new Float32Array(9 * ends.at(-1));
  const distances = new Float32Array(3 * ends.at(-1));
  const of_corners = new Float32Array(3 * order.length);
  const of_vertex = new Float32Array(at.length / 3).fill(-1);
  const places = new Float32Array((3 * (most_steps + 1) * (most_steps + 2)) / 2);
  const known = new Float32Array(places.length / 3);
  let to = 0;
  order.forEach((triangle, place) => {
    const division = subdivided(steps[place]);
    const [a, b, c] = indices.subarray(3 * triangle, 3 * triangle + 3);
    division.points.forEach(([u, v], i) => {
      for (let axis = 0; axis < 3; ++axis) {
        places[3 * i + axis] = at[3 * a + axis] * (1 - u - v) + at[3 * b + axis] * u + at[3 * c + axis] * v;
      }
      const vertex = u === 1 ? b : v === 1 ? c : u + v === 0 ? a : null;
      const is_known = vertex !== null && of_vertex[vertex] >= 0;
      known[i] = is_known ? of_vertex[vertex] : surface.distance(...places.subarray(3 * i, 3 * i + 3));
      if (vertex !== null) of_vertex[vertex] = known[i];
    });
    of_corners.set([of_vertex[a], of_vertex[b], of_vertex[c]], 3 * place);
    for (const corner of division.corners) {
      corners.set(places.subarray(3 * corner, 3 * corner + 3), 3 * to);
      distances[to++] = known[corner];
    }
  });
  return { corners, distances, ends, of_corners };
}

/**
 * @param {import('./shown_state.js').ShownState} state
 * @param {Float32Array[]} positions  [part] of its vertices
 * @param {import('./nearest_surface.js').NearestSurface} surface  the other one
 * @returns {{largest: number, parts: object[]}}  largest: of all distances
 *   Parts have small triangles of about one size, in the sequence of order k: divided_part() tells the rest.
 */
export function deviation_of(state, k, positions, surface) {
  const parts = positions.map((at, part) => ({ order: state.order(k, part), indices: state.indices(part), at }));
  const edges = parts.map(({ order, indices, at }) => squared_edges(order, indices, at));
  const all = edges.reduce((sum, of_part) => of_part.reduce((of, square) => of + square, sum), 0);
  const length = Math.sqrt(all / small_triangles) || 1;
  const divided = parts.map((part, i) => {
    const steps = Uint8Array.from(edges[i], (square) =>
      Math.max(1, Math.min(most_steps, Math.round(Math.sqrt(square) / length))),
    );
    return divided_part({ ...part, steps }, surface);
  });
  const largest = divided.reduce((most, { distances }) => distances.reduce((a, b) => Math.max(a, b), most), 0);
  return { largest, parts: divided };
}

/** So many colours, each up to twice the distance of the one before: the first is up to 1, 2 or 5 times a power of ten. */
export function distance_bounds(largest, colours) {
  if (!(largest > 0)) return [];
  const least = largest / 2 ** (colours - 1);
  const power = 10 ** Math.floor(Math.log10(least));
  const first = [1, 2, 5, 10].find((times) => times * power >= least) * power;
  return Array.from({ length: colours }, (_, i) => first * 2 ** i);
}
