// How far a state's surface is from the input's, point by point: vertices alone would not do, for a simplifier may leave
// each of them on the input's surface.

const small_triangles = 40_000; // about so many in all, where a state has fewer
const most_steps = 24;

/** Barycentric coordinates of a triangle's points, and the corners of the small triangles among them. */
function subdivided(steps) {
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
  return { points, corners };
}

/**
 * @param {import('./shown_state.js').ShownState} state
 * @param {Float32Array[]} positions  [part] of its vertices
 * @param {import('./nearest_surface.js').NearestSurface} surface  the input's
 * @returns {{small: number, largest: number, parts: {corners: Float32Array, distances: Float32Array}[]}}
 *   small: into how many triangles each is divided. Parts have them as their triangles are drawn in order k.
 */
export function deviation_of(state, k, positions, surface) {
  const wanted = Math.floor(Math.sqrt(small_triangles / Math.max(1, state.triangles)));
  const { points, corners } = subdivided(Math.max(1, Math.min(most_steps, wanted)));
  const small = corners.length / 3;
  let largest = 0;

  function of_part(part) {
    const [order, indices, at] = [state.order(k, part), state.indices(part), positions[part]];
    const of_vertex = new Float32Array(at.length / 3).fill(-1);
    const made = {
      corners: new Float32Array(9 * small * order.length),
      distances: new Float32Array(3 * small * order.length),
    };
    const places = new Float32Array(3 * points.length);
    const distances = new Float32Array(points.length);
    let to = 0;
    for (const triangle of order) {
      const [a, b, c] = indices.subarray(3 * triangle, 3 * triangle + 3);
      points.forEach(([u, v], i) => {
        const [x, y, z] = [0, 1, 2].map(
          (axis) => at[3 * a + axis] * (1 - u - v) + at[3 * b + axis] * u + at[3 * c + axis] * v,
        );
        places.set([x, y, z], 3 * i);
        const vertex = u === 1 ? b : v === 1 ? c : u === 0 && v === 0 ? a : null;
        const known = vertex === null ? -1 : of_vertex[vertex];
        distances[i] = known < 0 ? surface.distance(x, y, z) : known;
        if (vertex !== null) of_vertex[vertex] = distances[i];
        largest = Math.max(largest, distances[i]);
      });
      for (const corner of corners) {
        made.corners.set(places.subarray(3 * corner, 3 * corner + 3), 3 * to);
        made.distances[to++] = distances[corner];
      }
    }
    return made;
  }

  const parts = state.parts.map((_, part) => of_part(part));
  return { small, largest, parts };
}

/** So many colours, each up to twice the distance of the one before: the first is up to 1, 2 or 5 times a power of ten. */
export function distance_bounds(largest, colours) {
  if (!(largest > 0)) return [];
  const least = largest / 2 ** (colours - 1);
  const power = 10 ** Math.floor(Math.log10(least));
  const first = [1, 2, 5, 10].find((times) => times * power >= least) * power;
  return Array.from({ length: colours }, (_, i) => first * 2 ** i);
}
