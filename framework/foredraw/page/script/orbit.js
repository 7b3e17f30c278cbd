// A camera that goes round a sphere of radius 1 at the origin. All lengths are in radii.

import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';

const distance = 4; // of the eye from the middle
const margin = 1.04;
const steepest = (87 * Math.PI) / 180; // nearer to the Y axis up would be another way
const start = [0.48, 0.36, 0.8];

/** +Y, but for directions along it: as the evaluators' camera has it. */
const up_for = (direction) => (Math.abs(direction.y) < 0.999 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1));

export class Orbit {
  constructor() {
    this.is_orthographic = true;
    this.slide = [0, 0]; // of the picture, in its pixels, to the right and downwards
    this.cameras = { true: new OrthographicCamera(), false: new PerspectiveCamera() };
    this.reset();
  }

  reset() {
    this.direction = new Vector3(...start).normalize(); // from the middle to the camera
    this.target = new Vector3();
    this.zoom = 1;
  }

  set_direction(direction) {
    const made = new Vector3(...direction);
    if (made.lengthSq() > 0) this.direction = made.normalize();
  }

  /** By angles, in radians: to the right around the Y axis, and upwards. */
  turn(right, up) {
    const { x, y, z } = this.direction;
    const azimuth = Math.atan2(x, z) + right;
    const height = Math.max(-steepest, Math.min(steepest, Math.asin(Math.max(-1, Math.min(1, y))) + up));
    this.direction.set(Math.sin(azimuth) * Math.cos(height), Math.sin(height), Math.cos(azimuth) * Math.cos(height));
  }

  zoom_by(factor) {
    this.zoom = Math.max(0.5, Math.min(40, this.zoom * factor));
  }

  /** In parts of the picture's smaller edge. */
  move(right, up) {
    const across = new Vector3().crossVectors(up_for(this.direction), this.direction).normalize();
    const upwards = new Vector3().crossVectors(this.direction, across);
    const scale = (2 * margin) / this.zoom;
    this.target
      .addScaledVector(across, right * scale)
      .addScaledVector(upwards, up * scale)
      .clampLength(0, 2);
  }

  /** Holds the whole sphere at zoom 1, whatever the picture's shape. @param {number} width  of it, in pixels */
  camera(aspect, width = 1) {
    const camera = this.cameras[this.is_orthographic];
    const fit = Math.max(1, 1 / aspect);
    if (this.is_orthographic) {
      camera.top = margin * fit;
      camera.right = camera.top * aspect;
      [camera.bottom, camera.left] = [-camera.top, -camera.right];
    } else {
      const edge = margin / Math.sqrt(distance * distance - 1); // where lines from the eye touch the sphere
      camera.fov = (2 * Math.atan(edge * fit) * 180) / Math.PI;
      camera.aspect = aspect;
    }
    camera.zoom = this.zoom;
    camera.near = distance - 1.01 - this.target.length();
    camera.far = distance + 1.01 + this.target.length();
    camera.setViewOffset(width, width / aspect, -this.slide[0], -this.slide[1], width, width / aspect);
    return look_from(camera, this.direction, distance, this.target);
  }
}

function look_from(camera, direction, from, target) {
  camera.up.copy(up_for(direction));
  camera.position.copy(target).addScaledVector(direction, from);
  camera.lookAt(target);
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  return camera;
}

const measuring = new OrthographicCamera();

/** The evaluators' camera: orthographic, a square that just holds the sphere, depths spread over its diameter. */
export function measuring_camera(direction, centre, radius) {
  const slack = 1e-6; // for what lies exactly on the sphere
  [measuring.left, measuring.right, measuring.bottom, measuring.top] = [-radius, radius, -radius, radius];
  measuring.near = radius * (1 - slack);
  measuring.far = radius * (3 + slack);
  return look_from(measuring, direction, 2 * radius, centre);
}
