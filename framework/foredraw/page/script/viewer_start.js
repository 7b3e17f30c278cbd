// Builds the viewer, where the browser can draw and the page has scenes.

import { Drawing, make_canvas } from './drawing.js';
import { element } from './elements.js';
import { listen } from './orbit_input.js';
import { Viewer } from './viewer.js';
import { add_controls } from './viewer_controls.js';
import { Panes } from './viewer_panes.js';

/**
 * Fills the section `holder`.
 * @returns {Viewer|null} null where nothing can be shown; the section then says why
 */
export function start_viewer(holder, comparison, scenes) {
  const made = scenes.length > 0 ? make_canvas() : null;
  if (made === null) {
    const why =
      scenes.length > 0
        ? 'This browser does not support WebGL 2, so nothing can be drawn here.'
        : 'There are no triangles to show.';
    holder.append(element('p', { class: 'note' }, why));
    return null;
  }
  const panes = new Panes(made.canvas);
  const viewer = new Viewer(comparison, scenes, new Drawing(made.canvas, made.context), panes);
  add_controls(holder, viewer, panes);
  for (const window of panes.windows) listen(window, viewer.orbit, () => viewer.changed());
  new ResizeObserver(() => viewer.changed()).observe(panes.whole);
  return viewer;
}

/** What tests use, and nothing more. */
export function viewer_interface(viewer, ready) {
  const bound = (...names) => Object.fromEntries(names.map((name) => [name, (...given) => viewer[name](...given)]));
  return {
    ready, // resolves when the first frame stands
    ...bound(
      'set_scene',
      'set_subject',
      'set_state',
      'set_mode',
      'set_drawn',
      'set_level',
      'set_pose',
      'set_direction',
      'set_orthographic',
      'set_slide',
      'show_worst_view',
      'pixel_counts',
      'overdraw',
      'drawn_triangles',
      'order_of',
      'picture',
    ),
    direction: () => viewer.orbit.direction.toArray(),
    deviation: (pane = 0) => viewer.drawn_order(viewer.shown(pane), viewer.order_of(pane)).deviation?.largest,
    level: () => viewer.level,
    poses: () => viewer.subject.poses,
    triangles: (pane = 0) => viewer.shown(pane).triangles,
  };
}
