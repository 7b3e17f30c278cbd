// How far points are from a surface: a tree of boxes over its triangles, halved along the longest side at the median.

const most_in_leaf = 4;

export class NearestSurface {
  /** @param {Float32Array} corners  nine numbers a triangle */
  constructor(corners) {
    this.corners = corners;
    const triangles = corners.length / 9;
    this.order = Uint32Array.from({ length: triangles }, (_, i) => i);
    this.nodes = []; // [first, end, right child, 0: a leaf]; the left child follows its parent
    this.middles = [0, 1, 2].map((axis) =>
      Float32Array.from({ length: triangles }, (_, t) => corners[9 * t + axis] + corners[9 * t + 3 + axis] + corners[9 * t + 6 + axis]),
    );
    if (triangles > 0) this.divide(0, triangles);
    this.middles = null;
    this.boxes = new Float32Array(6 * this.nodes.length);
    this.hint = 0;
    this.moves = 0;
    this.fit();
  }

  /** The same triangles somewhere else. */
  move(corners) {
    this.corners = corners;
    ++this.moves;
    this.fit();
  }

  divide(first, end) {
    const node = [first, end, 0];
    this.nodes.push(node);
    if (end - first <= most_in_leaf) return;
    let longest = 0;
    let most = -1;
    this.middles.forEach((along, axis) => {
      let [low, high] = [Infinity, -Infinity];
      for (let i = first; i < end; ++i) {
        low = Math.min(low, along[this.order[i]]);
        high = Math.max(high, along[this.order[i]]);
      }
      if (high - low > most) [longest, most] = [axis, high - low];
    });
    const half = (first + end) >> 1;
    select(this.order, this.middles[longest], first, end - 1, half);
    this.divide(first, half);
    node[2] = this.nodes.length;
    this.divide(half, end);
  }

  /** Boxes of children are made before those of their parents. */
  fit() {
    const { boxes, corners, nodes, order } = this;
    for (let n = nodes.length - 1; n >= 0; --n) {
      const [first, end, right] = nodes[n];
      const to = 6 * n;
      for (let axis = 0; axis < 3; ++axis) {
        let [low, high] = [Infinity, -Infinity];
        if (right > 0) {
          low = Math.min(boxes[6 * n + 6 + axis], boxes[6 * right + axis]);
          high = Math.max(boxes[6 * n + 9 + axis], boxes[6 * right + 3 + axis]);
        } else {
          for (let i = first; i < end; ++i) {
            for (let at = 9 * order[i] + axis; at < 9 * order[i] + 9; at += 3) {
              low = Math.min(low, corners[at]);
              high = Math.max(high, corners[at]);
            }
          }
        }
        boxes[to + axis] = low;
        boxes[to + 3 + axis] = high;
      }
    }
    this.rounding = 2 ** -21 * Math.max(...boxes.subarray(0, 6).map(Math.abs));
  }

  /**
   * Of the nearest point of any triangle: 0 where floats would round it away, Infinity where there is no triangle.
   * Faster where the point before was near this one.
   */
  distance(x, y, z) {
    const { boxes, corners, nodes, order } = this;
    if (nodes.length === 0) return Infinity;
    let least = squared_distance(corners, 9 * this.hint, x, y, z);
    const open = [0];
    while (open.length > 0) {
      const n = open.pop();
      if (squared_to_box(boxes, 6 * n, x, y, z) >= least) continue;
      const [first, end, right] = nodes[n];
      if (right > 0) {
        const is_left_nearer = squared_to_box(boxes, 6 * n + 6, x, y, z) < squared_to_box(boxes, 6 * right, x, y, z);
        if (is_left_nearer) open.push(right, n + 1);
        else open.push(n + 1, right);
        continue;
      }
      for (let i = first; i < end; ++i) {
        const squared = squared_distance(corners, 9 * order[i], x, y, z);
        if (squared < least) [least, this.hint] = [squared, order[i]];
      }
    }
    return least > this.rounding ** 2 ? Math.sqrt(least) : 0;
  }
}

/** Puts the element that belongs at `middle` there, none greater before it, none smaller behind it (Hoare 1961). */
function select(order, key, low, high, middle) {
  while (low < high) {
    const pivot = key[order[(low + high) >> 1]];
    let [i, j] = [low, high];
    while (i <= j) {
      while (key[order[i]] < pivot) ++i;
      while (key[order[j]] > pivot) --j;
      if (i <= j) {
        [order[i], order[j]] = [order[j], order[i]];
        ++i;
        --j;
      }
    }
    if (middle <= j) high = j;
    else if (middle >= i) low = i;
    else return;
  }
}

function squared_to_box(boxes, at, x, y, z) {
  const dx = Math.max(boxes[at] - x, 0, x - boxes[at + 3]);
  const dy = Math.max(boxes[at + 1] - y, 0, y - boxes[at + 4]);
  const dz = Math.max(boxes[at + 2] - z, 0, z - boxes[at + 5]);
  return dx * dx + dy * dy + dz * dz;
}

/** Of the triangle whose nine numbers begin at `t`: above its plane's inside that of the plane, else of an edge. */
function squared_distance(c, t, x, y, z) {
  const [ax, ay, az] = [x - c[t], y - c[t + 1], z - c[t + 2]];
  const [ux, uy, uz] = [c[t + 3] - c[t], c[t + 4] - c[t + 1], c[t + 5] - c[t + 2]];
  const [vx, vy, vz] = [c[t + 6] - c[t], c[t + 7] - c[t + 1], c[t + 8] - c[t + 2]];
  const [uu, uv, vv] = [ux * ux + uy * uy + uz * uz, ux * vx + uy * vy + uz * vz, vx * vx + vy * vy + vz * vz];
  const [au, av] = [ax * ux + ay * uy + az * uz, ax * vx + ay * vy + az * vz];
  const area = uu * vv - uv * uv;
  const b = vv * au - uv * av;
  const d = uu * av - uv * au;
  const squared_at = (s, r) => (ax - s * ux - r * vx) ** 2 + (ay - s * uy - r * vy) ** 2 + (az - s * uz - r * vz) ** 2;
  if (area > 1e-12 * uu * vv && b >= 0 && d >= 0 && b + d <= area) return squared_at(b / area, d / area);
  const along = (way, length) => (length > 0 ? Math.max(0, Math.min(1, way / length)) : 0);
  const ww = uu - 2 * uv + vv;
  const w = along(av - uv - au + uu, ww); // from the second corner to the third
  return Math.min(squared_at(along(au, uu), 0), squared_at(0, along(av, vv)), squared_at(1 - w, w));
}
