// A state in one of its orders, on the graphics device: one geometry for each part, drawn with one call each.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, Scene } from 'three';
import { DeviationMap } from './deviation_map.js';
import { fill_cluster_colours, fill_corners, fill_order_colours } from './triangles.js';
import { WireParts } from './wire_parts.js';

/** Of a triangle: nine floats and three colours. */
export const bytes_per_triangle = 48;

export class DrawnOrder {
  /**
   * @param {import('./shown_state.js').ShownState} state
   * @param frame  the sphere that is brought to the origin and to radius 1
   */
  constructor(state, k, frame) {
    Object.assign(this, { state, k, frame, pose: null, way: 0, tints: null, deviation: null, wires: null });
    this.scene = new Scene();
    this.scene.matrixWorldAutoUpdate = false;
    this.meshes = state.parts.map((part) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', dynamic(new Float32Array(9 * part.triangles), 3, false));
      const mesh = new Mesh(geometry);
      mesh.frustumCulled = false;
      return mesh;
    });
    for (const part of state.sequence(k)) this.scene.add(this.meshes[part]);
  }

  /** @param {number} way  to the next coarser level, 0 to 1 */
  set_pose(pose, way) {
    if (this.pose === pose && this.way === way) return;
    this.drop_deviation();
    const { state } = this;
    this.meshes.forEach(({ geometry }, part) => {
      const attribute = geometry.attributes.position;
      // Many poses share their positions.
      const { positions } = state.parts[part];
      if (this.pose !== null && positions[this.pose] === positions[pose] && this.way === way) return;
      fill_corners(
        attribute.array,
        state.positions_on_way(part, pose, way),
        state.indices(part),
        state.order(this.k, part),
        this.frame.centre,
        this.frame.radius,
      );
      attribute.needsUpdate = true;
    });
    Object.assign(this, { pose, way });
  }

  /** As it is posed now, from there. @param {import('./nearest_surface.js').NearestSurface} surface */
  set_deviation(surface) {
    if (this.deviation?.is_from(surface)) return;
    this.drop_deviation();
    this.deviation = new DeviationMap(this, surface);
    this.meshes.forEach(({ geometry }, part) => {
      const { of_corners } = this.deviation.parts[part];
      if (!geometry.attributes.away) geometry.setAttribute('away', dynamic(of_corners, 1, false));
      geometry.attributes.away.array.set(of_corners);
      geometry.attributes.away.needsUpdate = true;
    });
  }

  drop_deviation() {
    this.deviation?.dispose();
    this.deviation = null;
  }

  /** Of a state that has some. */
  wire_parts() {
    this.wires ??= new WireParts(this);
    return this.wires;
  }

  /** @param {'order'|'clusters'} tints */
  set_tints(tints) {
    if (this.tints === tints) return;
    this.tints = tints;
    const { state } = this;
    const before = state.triangles_before(this.k);
    let first_cluster = 0;
    this.meshes.forEach(({ geometry }, part) => {
      const { triangles } = state.parts[part];
      if (!geometry.attributes.tint) geometry.setAttribute('tint', dynamic(new Uint8Array(12 * triangles), 4, true));
      const { array } = geometry.attributes.tint;
      const words = new Uint32Array(array.buffer);
      if (tints === 'order') {
        fill_order_colours(words, triangles, before[part], state.triangles);
      } else {
        const offsets = state.clusters(this.k, part);
        fill_cluster_colours(words, triangles, offsets, first_cluster);
        first_cluster += offsets === null ? 1 : offsets.length - 1;
      }
      geometry.attributes.tint.needsUpdate = true;
    });
  }

  /** Exactly the first n triangles of all parts in sequence. */
  set_drawn(n) {
    const drawn = this.state.drawn_of_parts(this.k, n);
    const show = (mesh, triangles) => {
      mesh.geometry.setDrawRange(0, 3 * triangles);
      mesh.visible = triangles > 0;
    };
    this.meshes.forEach((mesh, part) => show(mesh, drawn[part]));
    this.deviation?.meshes.forEach((mesh, part) => show(mesh, this.deviation.parts[part].ends[drawn[part]]));
  }

  /** @param {(part: object, pose: number) => import('three').Material} material_of */
  set_materials(material_of) {
    for (const meshes of [this.meshes, this.deviation?.meshes ?? []]) {
      meshes.forEach((mesh, part) => {
        mesh.material = material_of(this.state.parts[part], this.pose);
      });
    }
  }

  dispose() {
    this.drop_deviation();
    for (const { geometry } of this.meshes) geometry.dispose();
  }
}

function dynamic(array, size, normalised) {
  const attribute = new BufferAttribute(array, size, normalised);
  attribute.usage = DynamicDrawUsage;
  return attribute;
}
