// The deviation of what is drawn, on the graphics device.

import { BufferAttribute, BufferGeometry, Mesh, Scene } from 'three';
import { deviation_of } from './deviation.js';

export class DeviationMap {
  /** @param {import('./drawn_order.js').DrawnOrder} of  as it is posed now */
  constructor(of, surface) {
    Object.assign(this, { surface, moves: surface.moves });
    const { state, k, frame, pose, way } = of;
    const positions = state.parts.map((_, part) => state.positions_on_way(part, pose, way));
    const { largest, parts } = deviation_of(state, k, positions, surface);
    Object.assign(this, { largest, parts });
    this.scene = new Scene();
    this.scene.matrixWorldAutoUpdate = false;
    this.meshes = parts.map(({ corners, distances }) => {
      const geometry = new BufferGeometry();
      const placed = corners.map((value, i) => (value - frame.centre[i % 3]) / frame.radius);
      geometry.setAttribute('position', new BufferAttribute(placed, 3));
      geometry.setAttribute('away', new BufferAttribute(distances, 1));
      const mesh = new Mesh(geometry);
      mesh.frustumCulled = false;
      return mesh;
    });
    for (const part of state.sequence(k)) this.scene.add(this.meshes[part]);
  }

  is_from(surface) {
    return surface === this.surface && surface.moves === this.moves;
  }

  dispose() {
    for (const { geometry } of this.meshes) geometry.dispose();
  }
}
