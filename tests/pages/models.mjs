// Models of which it is known by reason what is to be seen, written as glTF with everything inside.

import { writeFileSync } from 'node:fs';

/** meshes: [{name, positions: [x, y, z, ...], indices: [...], scale: [x, y, z]}], one node for each. */
export function write_gltf(file, meshes, material = {}) {
  const chunks = [];
  let length = 0;
  const view_of = (array) => {
    const bytes = Buffer.from(array.buffer);
    chunks.push(bytes);
    length += bytes.length;
    return { buffer: 0, byteOffset: length - bytes.length, byteLength: bytes.length };
  };
  const bufferViews = [];
  const accessors = [];
  const gltf_meshes = meshes.map(({ name, positions, indices }) => {
    const along = (axis) => positions.filter((_, i) => i % 3 === axis);
    bufferViews.push(view_of(Float32Array.from(positions)), view_of(Uint32Array.from(indices)));
    accessors.push(
      {
        bufferView: bufferViews.length - 2,
        componentType: 5126,
        count: positions.length / 3,
        type: 'VEC3',
        min: [0, 1, 2].map((axis) => along(axis).reduce((a, b) => Math.min(a, b))),
        max: [0, 1, 2].map((axis) => along(axis).reduce((a, b) => Math.max(a, b))),
      },
      { bufferView: bufferViews.length - 1, componentType: 5125, count: indices.length, type: 'SCALAR' },
    );
    return {
      name,
      primitives: [{ attributes: { POSITION: accessors.length - 2 }, indices: accessors.length - 1, material: 0 }],
    };
  });
  writeFileSync(
    file,
    JSON.stringify({
      asset: { version: '2.0' },
      scene: 0,
      scenes: [{ nodes: meshes.map((_, i) => i) }],
      nodes: meshes.map(({ name, scale }, mesh) => ({ name, mesh, ...(scale && { scale }) })),
      meshes: gltf_meshes,
      materials: [material],
      bufferViews,
      accessors,
      buffers: [
        { byteLength: length, uri: `data:application/octet-stream;base64,${Buffer.concat(chunks).toString('base64')}` },
      ],
    }),
  );
  return file;
}

/** Rectangles that face +Z, drawn as they come: [x0, y0, x1, y1, z], the triangle at the lower right first. */
export function rectangles(...all) {
  return {
    positions: all.flatMap(([x0, y0, x1, y1, z]) => [x0, y0, z, x1, y0, z, x1, y1, z, x0, y1, z]),
    indices: all.flatMap((_, i) => [0, 1, 2, 0, 2, 3].map((corner) => 4 * i + corner)),
  };
}

/** A tube of eight sides from place to place, with open ends; a ring at each place. The first two are apart. */
export function tube(places, radius) {
  const sides = 8;
  const positions = [];
  const indices = [];
  const along = places[1].map((x, axis) => x - places[0][axis]);
  const cross = (a, b) => [0, 1, 2].map((i) => a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
  const unit = (a) => a.map((x) => x / Math.hypot(...a));
  const u = unit(cross(along, Math.abs(along[2]) < Math.hypot(...along) / 2 ? [0, 0, 1] : [0, 1, 0]));
  const v = unit(cross(along, u));
  places.forEach((place, ring) => {
    for (let side = 0; side < sides; ++side) {
      const [s, c] = [Math.sin((2 * Math.PI * side) / sides), Math.cos((2 * Math.PI * side) / sides)];
      positions.push(...place.map((x, axis) => x + radius * (c * u[axis] + s * v[axis])));
      if (ring === 0) continue;
      const [a, b] = [(ring - 1) * sides + side, (ring - 1) * sides + ((side + 1) % sides)];
      indices.push(a, b, a + sides, b, b + sides, a + sides);
    }
  });
  return { positions, indices };
}

/** A torus of 2 * around * across triangles. */
export function torus(around, across) {
  const positions = [];
  const indices = [];
  const vertex = (i, j) => (i % around) * across + (j % across);
  for (let i = 0; i < around; ++i) {
    for (let j = 0; j < across; ++j) {
      const [a, b] = [(2 * Math.PI * i) / around, (2 * Math.PI * j) / across];
      const radius = 1 + 0.4 * Math.cos(b);
      positions.push(radius * Math.cos(a), 0.4 * Math.sin(b), radius * Math.sin(a));
      indices.push(
        vertex(i, j),
        vertex(i, j + 1),
        vertex(i + 1, j + 1),
        vertex(i, j),
        vertex(i + 1, j + 1),
        vertex(i + 1, j),
      );
    }
  }
  return { positions, indices };
}
