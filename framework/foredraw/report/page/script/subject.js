// One subject of a scene, in all its states.

import { heat } from './colours.js';
import { deviation_of, distance_bounds } from './deviation.js';
import { NearestSurface } from './nearest_surface.js';
import { ShownState } from './shown_state.js';

/**
 * What the page's JSON calls a subject.
 *   states: [0] the input, [i + 1] branch i; null where it can not be shown, and absent[i] says why
 *   frame: the sphere around the input, in all poses; cameras look at it whatever the state
 */
export class Subject {
  constructor(description, buffer) {
    this.name = description.name;
    this.note = description.note ?? '';
    this.poses = description.poses;
    this.absent = description.absent ?? {};
    this.states = description.states.map(
      (state) => state && new ShownState(state, description.geometries, buffer),
    );
    this.frame = this.states[0].whole;
    this.deviations = new Map();
  }

  /** The input's in this pose, until another one is asked for. */
  surface(pose) {
    if (this.surface_pose === pose) return this.input_surface;
    this.surface_pose = pose;
    const [input] = this.states;
    const corners = new Float32Array(9 * input.triangles);
    input.parts.forEach((_, part) => {
      const positions = input.positions(part, pose);
      const first = 9 * input.first_triangle[part];
      input.indices(part).forEach((vertex, i) => {
        corners.set(positions.subarray(3 * vertex, 3 * vertex + 3), first + 3 * i);
      });
    });
    if (this.input_surface) this.input_surface.move(corners);
    else this.input_surface = new NearestSurface(corners);
    return this.input_surface;
  }

  /** For a legend of these states, whatever their level and pose. */
  distance_bounds(states) {
    return distance_bounds(Math.max(...states.map((state) => this.largest_deviation(state))), heat.length);
  }

  /** The largest distance from the input that is found on a state at its coarsest, in the first pose. */
  largest_deviation(number) {
    if (!this.deviations.has(number)) {
      const state = this.states[number].at(Infinity);
      const positions = state.parts.map((_, part) => state.positions(part, 0));
      this.deviations.set(number, deviation_of(state, 0, positions, this.surface(0)).largest);
    }
    return this.deviations.get(number);
  }
}
