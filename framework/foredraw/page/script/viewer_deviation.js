// What panes are held against in the heat map of the deviation: a state against the input, the input against the state
// beside it. So what was added is seen on one side, and what was lost on the other.

import { length_text } from './elements.js';

/** The pane that this one is held against; null: the input in full detail. */
function held_against(viewer, pane) {
  const [input] = viewer.subject.states;
  const is_input = viewer.shown(pane) === input && viewer.way_of(input) === 0;
  return is_input && viewer.states[1 - pane] !== null ? 1 - pane : null;
}

/** @returns {import('./nearest_surface.js').NearestSurface} */
export function surface_beside(viewer, pane) {
  const other = held_against(viewer, pane);
  const shown = other === null ? viewer.subject.states[0] : viewer.shown(other);
  return viewer.subject.surface(shown, viewer.pose, other === null ? 0 : viewer.way_of(shown));
}

/** What the colours tell. */
export function distance_text(viewer) {
  const is_both_ways = viewer.shown_panes().some((pane) => held_against(viewer, pane) !== null);
  return is_both_ways
    ? 'distance from the other surface, in units of the input'
    : 'distance from the surface of the input, in its units';
}

export function largest_text(viewer, pane, largest) {
  const from = held_against(viewer, pane) === null ? 'the input' : 'the other surface';
  return largest > 0 ? `up to ${length_text(largest)} away from ${from}` : `nowhere away from ${from}`;
}
