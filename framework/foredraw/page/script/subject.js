// One subject of a scene, in all its states.

import { heat } from './colours.js';
import { deviation_of, distance_bounds } from './deviation.js';
import { NearestSurface } from './nearest_surface.js';
import { ShownState } from './shown_state.js';

const kept_surfaces = 2;

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
    this.surfaces = new Map(); // those that were asked for last at the end
  }

  /** Of a state or one of its levels in this pose and on this way to the next level, until another one is asked for. */
  surface(state, pose, way) {
    const known = this.surfaces.get(state);
    if (known?.pose === pose && known.way === way) return known.surface;
    const corners = new Float32Array(9 * state.triangles);
    state.parts.forEach((_, part) => {
      const positions = state.positions_on_way(part, pose, way);
      const first = 9 * state.first_triangle[part];
      state.indices(part).forEach((vertex, i) => {
        corners.set(positions.subarray(3 * vertex, 3 * vertex + 3), first + 3 * i);
      });
    });
    const surface = known?.surface ?? new NearestSurface(corners);
    if (known) surface.move(corners);
    this.surfaces.delete(state);
    if (this.surfaces.size >= kept_surfaces) this.surfaces.delete(this.surfaces.keys().next().value);
    this.surfaces.set(state, { surface, pose, way });
    return surface;
  }

  /** For a legend of these states, whatever their level and pose. */
  distance_bounds(states) {
    return distance_bounds(Math.max(...states.map((state) => this.largest_deviation(state))), heat.length);
  }

  /** The largest distance between the input and a state at its coarsest, either way, in the first pose. */
  largest_deviation(number) {
    if (!this.deviations.has(number)) {
      const [input, state] = [this.states[0], this.states[number].at(Infinity)];
      const largest_of = (one, other) => {
        const positions = one.parts.map((_, part) => one.positions(part, 0));
        return deviation_of(one, 0, positions, this.surface(other, 0, 0)).largest;
      };
      const is_input = state === input;
      this.deviations.set(number, is_input ? 0 : Math.max(largest_of(state, input), largest_of(input, state)));
    }
    return this.deviations.get(number);
  }
}
