// The wires of a state's parts on the graphics device: what their corners know, and from which space.

import { BufferAttribute, DoubleSide, Matrix4 } from 'three';

const row_floats = 11; // of a row: a position, _FOREDRAW_WIRE, _FOREDRAW_WIRE_AXIS
const clearly = 0.3; // of a section's triangles, which side shows; where it is less clear, both are drawn

/** 1: counterclockwise from outside, -1: from inside, 0: it is flat, or not known. Corners: places of rows. */
function outside_of(rows, corners) {
  const [a, b, c] = corners.map((row) => rows.subarray(row, row + 3));
  const [u, v] = [b, c].map((corner) => corner.map((x, axis) => x - a[axis]));
  const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const inwards = [3, 4, 5].map((axis) => corners.reduce((sum, row) => sum + rows[row + axis], 0));
  const along = normal.reduce((sum, x, axis) => sum + x * inwards[axis], 0);
  return Math.abs(along) > clearly * Math.hypot(...normal) * Math.hypot(...inwards) ? -Math.sign(along) : 0;
}

/** Adds to the geometry what `wire_materials.js` reads; of what is no wire all is 0. */
function add_attributes(geometry, { first, corners, rows }) {
  const count = geometry.attributes.position.count;
  const [places, wires, axes] = [0, 1, 2].map(() => new Float32Array(4 * count));
  for (let i = 0; i < corners.length; i += 3) {
    const from = Array.from(corners.subarray(i, i + 3), (row) => row_floats * row);
    const outside = outside_of(rows, from);
    from.forEach((row, corner) => {
      const to = 4 * (3 * first + i + corner);
      places.set(rows.subarray(row, row + 3), to);
      places[to + 3] = outside;
      wires.set(rows.subarray(row + 3, row + 7), to);
      axes.set(rows.subarray(row + 7, row + 11), to);
    });
  }
  geometry.setAttribute('wire_place', new BufferAttribute(places, 4));
  geometry.setAttribute('wire', new BufferAttribute(wires, 4));
  geometry.setAttribute('wire_axis', new BufferAttribute(axes, 4));
}

export class WireParts {
  /** @param {import('./drawn_order.js').DrawnOrder} order  of a state with wires */
  constructor(order) {
    this.order = order;
    this.shown_from_mesh = new Matrix4();
    this.clip_from_mesh = new Matrix4();
    this.parts = order.meshes.map((_, part) => order.state.wires_of(part));
    const { centre, radius } = order.frame;
    this.into_frame = new Matrix4()
      .makeScale(1 / radius, 1 / radius, 1 / radius)
      .multiply(new Matrix4().makeTranslation(...centre.map((c) => -c)));
    order.meshes.forEach((mesh, part) => {
      if (this.parts[part] === null) return;
      add_attributes(mesh.geometry, this.parts[part]);
      mesh.onBeforeRender = (renderer, scene, camera, geometry, material) => {
        if (material.uniforms.clip_from_mesh) this.tell(part, renderer, camera, material);
      };
    });
  }

  /** The material's uniforms, for this part. */
  tell(part, renderer, camera, material) {
    const { uniforms } = material;
    const { pose, state } = this.order;
    this.shown_from_mesh.fromArray(this.parts[part].from_mesh[pose]).premultiply(this.into_frame);
    this.clip_from_mesh
      .multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse)
      .multiply(this.shown_from_mesh);
    uniforms.shown_from_mesh.value.copy(this.shown_from_mesh);
    uniforms.clip_from_mesh.value.copy(this.clip_from_mesh);
    renderer.getCurrentViewport(uniforms.pane.value);
    const is_mirrored = state.parts[part].mirrored?.[pose] ?? false;
    uniforms.outwards.value = material.side === DoubleSide ? (is_mirrored ? -1 : 1) : 0;
    material.uniformsNeedUpdate = true;
  }

  /** Draws the scene of the order with what wires are asked for: everything, or the triangles of wires alone. */
  draw(render, materials, solid) {
    const { order } = this;
    const has_wires = (part) => this.parts[part] !== null;
    order.set_materials((part, pose) => (has_wires(order.state.parts.indexOf(part)) ? materials.opaque : solid)(part, pose));
    render();
    order.set_materials(materials.faded);
    const ranges = order.meshes.map(({ geometry, visible }) => ({ ...geometry.drawRange, visible }));
    order.meshes.forEach((mesh, part) => {
      const end = ranges[part].start + ranges[part].count;
      const first = has_wires(part) ? 3 * this.parts[part].first : end;
      mesh.visible = ranges[part].visible && end > first;
      if (mesh.visible) mesh.geometry.setDrawRange(first, end - first);
    });
    render();
    order.meshes.forEach((mesh, part) => {
      mesh.visible = ranges[part].visible;
      mesh.geometry.setDrawRange(ranges[part].start, ranges[part].count);
    });
  }
}
