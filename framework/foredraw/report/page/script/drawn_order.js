// A subject in one order, on the graphics device: one geometry for each part, drawn with one call each.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Mesh, Scene } from 'three';
import { fill_cluster_colours, fill_corners, fill_order_colours } from './triangles.js';

/** Of a triangle: nine floats and three colours. */
export const bytes_per_triangle = 48;

export class DrawnOrder {
  constructor(subject, state, k) {
    Object.assign(this, { subject, state, k, pose: null, tints: null });
    this.scene = new Scene();
    this.scene.matrixWorldAutoUpdate = false;
    this.meshes = subject.parts.map((part) => {
      const geometry = new BufferGeometry();
      geometry.setAttribute('position', dynamic(new Float32Array(9 * part.triangles), 3, false));
      const mesh = new Mesh(geometry);
      mesh.frustumCulled = false;
      this.scene.add(mesh);
      return mesh;
    });
  }

  set_pose(pose) {
    if (this.pose === pose) return;
    const { subject } = this;
    this.meshes.forEach(({ geometry }, part) => {
      const attribute = geometry.attributes.position;
      // Many poses share their positions.
      if (this.pose !== null && subject.parts[part].positions[this.pose] === subject.parts[part].positions[pose])
        return;
      fill_corners(
        attribute.array,
        subject.positions(part, pose),
        subject.indices(part),
        subject.order(this.state, this.k, part),
        subject.centre,
        subject.radius,
      );
      attribute.needsUpdate = true;
    });
    this.pose = pose;
  }

  /** @param {'order'|'clusters'} tints */
  set_tints(tints) {
    if (this.tints === tints) return;
    this.tints = tints;
    const { subject } = this;
    let first_cluster = 0;
    this.meshes.forEach(({ geometry }, part) => {
      const { triangles } = subject.parts[part];
      if (!geometry.attributes.tint) geometry.setAttribute('tint', dynamic(new Uint8Array(12 * triangles), 4, true));
      const { array } = geometry.attributes.tint;
      const words = new Uint32Array(array.buffer);
      if (tints === 'order') {
        fill_order_colours(words, triangles, subject.first_triangle[part], subject.triangles);
      } else {
        const offsets = subject.clusters(this.state, this.k, part);
        fill_cluster_colours(words, triangles, offsets, first_cluster);
        first_cluster += offsets === null ? 1 : offsets.length - 1;
      }
      geometry.attributes.tint.needsUpdate = true;
    });
  }

  /** Exactly the first n triangles of all parts in sequence. */
  set_drawn(n) {
    this.meshes.forEach((mesh, part) => {
      const drawn = this.subject.drawn_of(part, n);
      mesh.geometry.setDrawRange(0, 3 * drawn);
      mesh.visible = drawn > 0;
    });
  }

  /** @param {(part: object, pose: number) => import('three').Material} material_of */
  set_materials(material_of) {
    this.meshes.forEach((mesh, part) => {
      mesh.material = material_of(this.subject.parts[part], this.pose);
    });
  }

  dispose() {
    for (const { geometry } of this.meshes) geometry.dispose();
  }
}

function dynamic(array, size, normalised) {
  const attribute = new BufferAttribute(array, size, normalised);
  attribute.usage = DynamicDrawUsage;
  return attribute;
}
