// What one state, the input or a pipeline, shows of a subject: typed views onto the decoded buffer. Nothing is copied.

/**
 * Its parts are drawn in their sequence, unless a table has others; several states may have the same parts.
 * Triangles are numbered over all parts: those of part p begin at first_triangle[p].
 */
export class ShownState {
  /**
   * @param {object} description  the state's, or that of one of its levels
   * @param {object[]} geometries  of the subject
   * @param {ArrayBuffer} buffer
   * @param {object[]} levels  those coarser than this one
   */
  constructor(description, geometries, buffer, levels = description.levels ?? []) {
    const { orders, sequences, table, ancestors, wires = null, error = 0 } = description;
    const geometry = geometries[description.geometry];
    Object.assign(this, { parts: geometry.parts, note: geometry.note ?? '', orders, sequences, table, buffer });
    Object.assign(this, { ancestors, wires, error }); // error: the largest distance from full detail; 0: not known
    this.coarser = levels.length === 0 ? null : new ShownState(levels[0], geometries, buffer, levels.slice(1));
    this.whole = { centre: geometry.centre, radius: geometry.radius > 0 ? geometry.radius : 1 };
    this.spheres = new Map();
    this.triangles = 0;
    this.first_triangle = this.parts.map((part) => {
      this.triangles += part.triangles;
      return this.triangles - part.triangles;
    });
  }

  // Levels of detail: this one is level 0 of those behind it.

  get levels() {
    return 1 + (this.coarser?.levels ?? 0);
  }

  /** The coarsest one, where there are fewer; what lies between two levels is on its way from the finer one. */
  at(level) {
    return level < 1 || this.coarser === null ? this : this.coarser.at(level - 1);
  }

  /** Whether vertices are known to move from this level to the next one. */
  get moves() {
    return this.coarser !== null && this.ancestors.some((of_part) => of_part !== null);
  }

  /** Whether they are from any level on. */
  get has_geomorphs() {
    return this.moves || (this.coarser?.has_geomorphs ?? false);
  }

  positions(part, pose) {
    const { positions, vertices } = this.parts[part];
    return new Float32Array(this.buffer, positions[pose], 3 * vertices);
  }

  /** On the way to the next coarser level, 0 to 1, as foredraw_geomorph() of runtime/geomorph.h has it. */
  positions_on_way(part, pose, way) {
    const fine = this.positions(part, pose);
    const from = way > 0 ? (this.ancestors?.[part] ?? null) : null;
    if (from === null) return fine;
    const ancestors = new Uint32Array(this.buffer, from, fine.length / 3);
    const coarse = this.coarser.positions(part, pose);
    return fine.map((a, i) => {
      const b = coarse[3 * ancestors[Math.floor(i / 3)] + (i % 3)];
      return Math.min(Math.max(a, b), Math.max(Math.min(a, b), a + (b - a) * way));
    });
  }

  get has_wires() {
    return this.wires !== null;
  }

  /** {first, corners, rows, from_mesh} as the program's shown_wires.h has them; null: the part has none. */
  wires_of(part) {
    const wires = this.wires?.[part] ?? null;
    if (wires === null) return null;
    const { first, corners, rows, 'row-count': count, 'from-mesh': from_mesh } = wires;
    return {
      first,
      corners: new Uint32Array(this.buffer, corners, 3 * (this.parts[part].triangles - first)),
      rows: new Float32Array(this.buffer, rows, 11 * count),
      from_mesh,
    };
  }

  indices(part) {
    return new Uint32Array(this.buffer, this.parts[part].indices, 3 * this.parts[part].triangles);
  }

  /** [new place] -> number of the triangle in the part */
  order(k, part) {
    return new Uint32Array(this.buffer, this.orders[k][part].triangles, this.parts[part].triangles);
  }

  /** Where clusters begin in the new order, the end of the last one behind them; null where there are none. */
  clusters(k, part) {
    const { clusters, 'cluster-count': count } = this.orders[k][part];
    return clusters === undefined || !count ? null : new Uint32Array(this.buffer, clusters, count + 1);
  }

  has_clusters() {
    return this.orders.some((parts) => parts.some((part) => part['cluster-count'] > 0));
  }

  /** [place] -> the part that is drawn there */
  sequence(k) {
    return this.sequences?.[k] ?? this.parts.map((_, part) => part);
  }

  /** [part] -> how many triangles of other parts are drawn before it */
  triangles_before(k) {
    const before = [];
    let triangles = 0;
    for (const part of this.sequence(k)) {
      before[part] = triangles;
      triangles += this.parts[part].triangles;
    }
    return before;
  }

  /** [part] -> how many of the first `drawn` triangles are of this part */
  drawn_of_parts(k, drawn) {
    const before = this.triangles_before(k);
    return this.parts.map(({ triangles }, part) => Math.max(0, Math.min(triangles, drawn - before[part])));
  }

  /** The numbers of the first `drawn` triangles in the sequence of drawing. */
  drawn_triangles(k, drawn) {
    const of_parts = this.drawn_of_parts(k, drawn);
    return this.sequence(k).flatMap((part) =>
      Array.from(
        this.order(k, part).subarray(0, of_parts[part]),
        (triangle) => this.first_triangle[part] + triangle,
      ),
    );
  }

  /** The sphere that an evaluator's picture of this pose just holds: the middle of the box, to the farthest corner. */
  sphere(pose) {
    if (this.parts.every(({ positions }) => positions.length === 1)) return this.whole;
    if (!this.spheres.has(pose))
      this.spheres.set(pose, sphere_around(this.parts.map((_, i) => this.positions(i, pose))));
    return this.spheres.get(pose);
  }
}

function sphere_around(arrays) {
  const least = [Infinity, Infinity, Infinity];
  const most = [-Infinity, -Infinity, -Infinity];
  for (const positions of arrays) {
    for (let i = 0; i < positions.length; ++i) {
      if (positions[i] < least[i % 3]) least[i % 3] = positions[i];
      if (positions[i] > most[i % 3]) most[i % 3] = positions[i];
    }
  }
  const centre = least.map((low, axis) => (low + most[axis]) / 2);
  let square = 0;
  for (const positions of arrays) {
    for (let i = 0; i < positions.length; i += 3) {
      const [x, y, z] = [positions[i] - centre[0], positions[i + 1] - centre[1], positions[i + 2] - centre[2]];
      square = Math.max(square, x * x + y * y + z * z);
    }
  }
  return { centre, radius: Math.sqrt(square) || 1 };
}
