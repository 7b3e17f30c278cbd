// In the browser: loads models by three.js' own loaders and compares what they draw, pixel by pixel.

import * as THREE from 'three';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';

const size = 256;
const noticed = 8; // of 255: two colours that are further apart in a channel differ
const directions = [
  [1, 0.6, 1],
  [-1, 0.4, 1],
  [-1, -0.5, -1],
  [1, 0.8, -1],
].map((direction) => new THREE.Vector3(...direction).normalize());

const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true });
renderer.setSize(size, size, false);
renderer.setClearColor(0x8090a0, 1);

const libraries = '/three/examples/jsm/libs';
const gltf_loader = new GLTFLoader()
  .setDRACOLoader(new DRACOLoader().setDecoderPath(`${libraries}/draco/gltf/`))
  .setKTX2Loader(new KTX2Loader().setTranscoderPath(`${libraries}/basis/`).detectSupport(renderer))
  .setMeshoptDecoder(MeshoptDecoder);

/** A mesh file's materials are no part of it: each of its faces has a colour by where it faces. */
function by_shape(object) {
  object.traverse((part) => {
    if (part.isMesh) part.material = new THREE.MeshNormalMaterial({ flatShading: true });
    if (part.isPoints) part.material = new THREE.PointsMaterial({ size: 2, sizeAttenuation: false });
    if (part.isLine) part.material = new THREE.LineBasicMaterial();
  });
  return { object, clips: [] };
}

async function load(address, is_mesh_file) {
  const kind = address.split('.').pop().toLowerCase();
  if (kind === 'obj') return by_shape(await new OBJLoader().loadAsync(address));
  if (kind === 'ply' || kind === 'stl') {
    const geometry = await new (kind === 'ply' ? PLYLoader : STLLoader)().loadAsync(address);
    const is_cloud = kind === 'ply' && !geometry.index;
    return by_shape(is_cloud ? new THREE.Points(geometry) : new THREE.Mesh(geometry));
  }
  const { scene, animations } = await gltf_loader.loadAsync(address);
  return is_mesh_file ? by_shape(scene) : { object: scene, clips: animations };
}

function camera_around(object) {
  object.updateMatrixWorld(true);
  const ball = new THREE.Box3().setFromObject(object).getBoundingSphere(new THREE.Sphere());
  if (!(ball.radius >= 0)) throw new Error('there is nothing to draw');
  if (!Number.isFinite(ball.radius + ball.center.length())) throw new Error('it has no extent');
  const radius = ball.radius || 1;
  const camera = new THREE.PerspectiveCamera(40, 1, radius * 0.5, radius * 8);
  return (direction) => {
    camera.position.copy(ball.center).addScaledVector(direction, radius * 3);
    camera.lookAt(ball.center);
    return camera;
  };
}

function pixels() {
  const drawn = new Uint8Array(size * size * 4);
  const gl = renderer.getContext();
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, drawn);
  return drawn;
}

/** Four views as it rests, and two within its first animation. */
function pictures({ object, clips }, camera_at) {
  const scene = new THREE.Scene();
  const lamp = new THREE.DirectionalLight(0xffffff, 2);
  scene.add(object, lamp, new THREE.HemisphereLight(0xffffff, 0x605040, 2));
  const drawn = [];
  const draw = (direction) => {
    const camera = camera_at(direction);
    lamp.position.copy(camera.position).add(camera.up);
    renderer.render(scene, camera);
    drawn.push({ pixels: pixels(), picture: renderer.domElement.toDataURL() });
  };
  directions.forEach(draw);
  if (clips.length) {
    const mixer = new THREE.AnimationMixer(object);
    mixer.clipAction(clips[0]).play();
    mixer.setTime(clips[0].duration * 0.4);
    directions.slice(0, 2).forEach(draw);
  }
  return drawn;
}

const far_apart = (a, b, at) =>
  [0, 1, 2].some((channel) => Math.abs(a[at + channel] - b[at + channel]) > noticed);

function count(holds) {
  let found = 0;
  for (let at = 0; at < size * size * 4; at += 4) found += holds(at) ? 1 : 0;
  return found;
}

window.look = async (before, after) => {
  const is_mesh_file = /\.(obj|ply|stl)$/i.test(before);
  renderer.clear();
  const empty = pixels();
  let first;
  let camera_at;
  try {
    first = await load(before, is_mesh_file);
    camera_at = camera_around(first.object);
  } catch (error) {
    return { shows: false, reason: String(error?.message ?? error).split('\n')[0] };
  }
  const drawn = pictures(first, camera_at);
  const views = drawn.map((view) => ({ covered: count((at) => far_apart(view.pixels, empty, at)) }));
  if (views.every((view) => view.covered === 0)) return { shows: false, reason: 'no pixel is drawn' };
  if (after) {
    const again = pictures(await load(after, is_mesh_file), camera_at);
    for (const [at, view] of views.entries()) {
      view.differing = count((pixel) => far_apart(drawn[at].pixels, again[at].pixels, pixel));
      if (view.differing) view.pictures = { before: drawn[at].picture, after: again[at].picture };
    }
  }
  return { shows: true, views };
};
