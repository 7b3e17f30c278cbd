// One subject of a scene, in all its states.

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
      (state) => state && new ShownState(description.geometries[state.geometry], state, buffer),
    );
    this.frame = this.states[0].whole;
  }
}
