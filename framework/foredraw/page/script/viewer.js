// The viewer: what is shown, and everything that changes it. Controls, tests and the frame all go through here.

import { Vector3 } from 'three';
import { colour_of } from './elements.js';
import { state_name } from './figures.js';
import { measuring_camera, Orbit } from './orbit.js';
import { order_at } from './order_table.js';
import { decoded_buffer } from './page_data.js';
import { Subject } from './subject.js';
import { largest_text, surface_beside } from './viewer_deviation.js';
import { overdraw_of, worst_view } from './worst_view.js';

export const modes = ['heat', 'shaded', 'order', 'clusters', 'deviation'];
const measured_size = 256; // as the evaluators have it
const worst_view_size = 128;
const quiet_ms = 120; // after the last change, before counts are read back

export class Viewer {
  /**
   * @param comparison  the page's
   * @param scenes      the page's list
   * @param {import('./drawing.js').Drawing} drawing
   * @param {import('./viewer_panes.js').Panes} panes
   */
  constructor(comparison, scenes, drawing, panes) {
    Object.assign(this, { comparison, scenes, drawing, panes });
    this.orbit = new Orbit();
    this.mode = 'heat';
    this.level = 0;
    this.listeners = [];
    this.frame = null;
    this.counting = null;
    this.set_scene(0);
  }

  // What is shown.

  get file() {
    return this.comparison.files[this.scenes[this.scene].file];
  }

  state_name(state) {
    return state_name(this.file, state);
  }

  /** What the pane shows. @returns {import('./shown_state.js').ShownState} */
  shown(pane) {
    return this.state_now(this.states[pane]);
  }

  /** At the level that is shown. */
  state_now(state) {
    return this.subject.states[state].at(this.level);
  }

  /** How far a state that is shown is on its way to the next coarser level: 0 to 1. */
  way_of(shown) {
    return shown.moves ? this.level % 1 : 0;
  }

  shown_panes() {
    return [0, 1].filter((pane) => this.states[pane] !== null);
  }

  /** Which of its orders the pane's state is drawn in now. */
  order_of(pane) {
    return order_at(this.shown(pane).table, this.subject.poses[this.pose], this.orbit.direction.toArray());
  }

  /** The number of the coarsest level that one of the panes can show. */
  get coarsest_level() {
    return Math.max(...this.shown_panes().map((pane) => this.subject.states[this.states[pane]].levels - 1));
  }

  /** Whether what lies between levels can be shown. */
  get has_geomorphs() {
    return this.shown_panes().some((pane) => this.subject.states[this.states[pane]].has_geomorphs);
  }

  /** Up to which distance each colour goes, the same at all levels; empty: nothing is away from the input. */
  get distance_bounds() {
    return this.subject.distance_bounds(this.shown_panes().map((pane) => this.states[pane]));
  }

  /** How many triangles can be drawn: those of the state that has most of the ones shown. */
  get most_drawn() {
    return Math.max(...this.shown_panes().map((pane) => this.shown(pane).triangles));
  }

  /** How many are drawn. A state that has fewer is drawn whole. */
  get drawn() {
    return Math.min(this.limit, this.most_drawn);
  }

  /** The numbers of the triangles that are drawn now, in the sequence of drawing; numbered over all parts. */
  drawn_triangles(pane) {
    return this.shown(pane).drawn_triangles(this.order_of(pane), this.drawn);
  }

  /** What is not shown of the subject, by state where states differ. */
  get notes() {
    const notes = this.shown_panes().map((pane) => this.shown(pane).note);
    const are_alike = notes.every((note) => note === notes[0]);
    const told = are_alike
      ? notes.slice(0, 1)
      : this.shown_panes().map((pane, i) => notes[i] && `${this.state_name(this.states[pane])}: ${notes[i]}`);
    return [...told, this.subject.note].filter((note) => note !== '');
  }

  // What changes it.

  set_scene(scene) {
    this.scene = scene;
    this.buffer = decoded_buffer(this.scenes[scene].buffer);
    this.set_subject(0);
  }

  set_subject(number) {
    this.subject_number = number;
    this.subject = new Subject(this.scenes[this.scene].subjects[number], this.buffer);
    this.drawing.set_subject(this.subject);
    this.states = [0, this.most_interesting_state()];
    this.level = 0;
    this.pose = 0;
    this.limit = Infinity;
    this.changed();
  }

  /** The branch with the least overdraw, or the first one that is shown; null where there is none. */
  most_interesting_state() {
    const shown = this.subject.states.flatMap((state, i) => (i > 0 && state !== null ? [i] : []));
    const row = this.file.metrics.find(
      ({ evaluator, metric }) => evaluator === 'overdraw-raster' && metric === 'ratio',
    );
    const ratio = (state) => row?.values?.[state - 1] ?? Infinity;
    return shown.reduce((best, state) => (best === null || ratio(state) < ratio(best) ? state : best), null);
  }

  /** @param {number|null} state  0: the input; i + 1: branch i; null: nothing, which the second pane alone can show */
  set_state(pane, state) {
    if (state === null ? pane === 0 : !this.subject.states[state]) return;
    this.states[pane] = state;
    this.changed();
  }

  set_mode(mode) {
    this.mode = modes.includes(mode) ? mode : this.mode;
    this.changed();
  }

  /** @param {number} level  0: full detail; what lies between two is shown where vertices are known to move there */
  set_level(level) {
    const within = Math.max(0, Math.min(this.coarsest_level, level));
    this.level = this.has_geomorphs ? within : Math.floor(within);
    this.changed();
  }

  set_drawn(n) {
    this.limit = n >= this.most_drawn ? Infinity : Math.max(0, Math.round(n)); // all: of whatever is shown later, too
    this.changed();
  }

  set_pose(pose) {
    this.pose = pose;
    this.changed();
  }

  set_direction(direction) {
    this.orbit.set_direction(direction);
    this.changed();
  }

  set_orthographic(is_orthographic) {
    this.orbit.is_orthographic = is_orthographic;
    this.changed();
  }

  /** Slides the picture by parts of a pixel, as a camera that moves slowly does. */
  set_slide(right, down) {
    this.orbit.slide = [right, down];
    this.changed();
  }

  reset_camera() {
    this.orbit.reset();
    this.changed();
  }

  // Drawing, when something changed and only then.

  on_change(listener) {
    this.listeners.push(listener);
  }

  changed() {
    clearTimeout(this.counting); // what is being counted is no longer what is shown
    this.counting = null;
    for (const listener of this.listeners) listener();
    this.frame ??= requestAnimationFrame(() => this.draw());
  }

  draw() {
    if (this.frame !== null) cancelAnimationFrame(this.frame);
    this.frame = null;
    this.panes.show(this.states.map((state) => state !== null));
    const orders = new Map(
      this.shown_panes().map((pane) => [pane, this.drawn_order(this.shown(pane), this.order_of(pane))]),
    );
    if (this.mode === 'deviation') {
      this.drawing.set_first_distance(this.distance_bounds[0] ?? Infinity);
      orders.forEach((order, pane) => order.set_deviation(surface_beside(this, pane)));
    }
    this.tell(); // before anything is drawn: a caption of another height moves the panes
    this.panes.fit((width, height, ratio) => this.drawing.set_size(width, height, ratio));
    const background = colour_of('--stage');
    this.drawing.clear();
    for (const [pane, order] of orders) {
      const place = this.panes.place(pane);
      if (place.width < 1 || place.height < 1) continue;
      const camera = this.orbit.camera(place.width / place.height, place.width * this.panes.ratio);
      this.drawing.draw_pane(place, this.mode, order, camera, this.drawn, background);
    }
    this.first_drawn?.();
  }

  drawn_order(shown, k) {
    return this.drawing.order(shown, k, this.pose, this.way_of(shown));
  }

  // Counts.

  /** Pictures of one state at the level, in the pose and up to the triangle that are shown, from several directions. */
  counted(state, directions, size) {
    const shown = this.state_now(state);
    const pose = this.subject.poses[this.pose];
    const { frame } = this.subject;
    const { centre, radius } = shown.sphere(this.pose);
    const middle = new Vector3(...centre.map((c, axis) => (c - frame.centre[axis]) / frame.radius));
    return this.drawing.counted(
      directions.map((direction) => ({
        order: () => this.drawn_order(shown, order_at(shown.table, pose, direction)),
        camera: () => measuring_camera(new Vector3(...direction), middle, radius / frame.radius),
      })),
      size,
      this.drawn,
    );
  }

  /**
   * How often each pixel of size x size is shaded, from the camera's direction, orthographic; row 0 at the bottom.
   * @returns {Promise<Uint8Array>}
   */
  async pixel_counts(pane, size) {
    return (await this.counted(this.states[pane], [this.orbit.direction.toArray()], size))[0];
  }

  /** What an evaluator would say of this one view: {shaded, visible, ratio}. */
  async overdraw(pane) {
    return overdraw_of(await this.pixel_counts(pane, measured_size));
  }

  /** Turns the camera to where the first pane's state has the highest ratio. */
  async show_worst_view() {
    const { subject } = this;
    const state = this.states[0];
    const is_shown = () => subject === this.subject;
    const worst = await worst_view((directions) =>
      is_shown() ? this.counted(state, directions, worst_view_size) : [],
    );
    if (worst !== null && is_shown()) this.set_direction(worst.direction);
    return worst;
  }

  /** Captions: at once what is known, the ratios when nothing has changed for a moment. */
  tell() {
    for (const pane of this.shown_panes()) {
      this.panes.tell(pane, this.state_name(this.states[pane]), this.remark_on(pane));
    }
    clearTimeout(this.counting);
    this.counting = setTimeout(() => this.tell_ratios(), quiet_ms);
  }

  remark_on(pane) {
    const shown = this.shown(pane);
    const k = this.order_of(pane);
    if (this.mode === 'deviation') {
      return largest_text(this, pane, this.drawn_order(shown, k).deviation?.largest ?? 0);
    }
    return shown.orders.length > 1 ? `order ${k + 1} of ${shown.orders.length}, for this view and pose` : '';
  }

  async tell_ratios() {
    const mine = this.counting;
    for (const pane of this.shown_panes()) {
      const { ratio } = await this.overdraw(pane);
      if (mine !== this.counting) return;
      this.panes.tell_ratio(pane, ratio);
    }
  }

  /** What the pane shows: {width, height, data} with four bytes for each pixel, row 0 at the bottom. */
  picture(pane) {
    this.draw();
    return this.drawing.read(this.panes.place(pane));
  }
}
