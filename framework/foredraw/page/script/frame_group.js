// What one technique attached, of as many frames: its charts and films of every state, with one slider for all.

import { make_curve_chart, measure_of } from './curve_chart.js';
import { branch_colour } from './colours.js';
import { css_colour, element } from './elements.js';
import { state_name } from './figures.js';
import { picture } from './page_data.js';
import { Player } from './player.js';
import { slider_row } from './slider_row.js';
import { is_dark_now } from './theme.js';

const frames_a_second = 30;
const least_seconds = 4; // of a short film as a whole
const open_states = 4; // more are opened by hand
const usual_width = 256; // of a picture, in pixels of the page: small ones are drawn a whole number of times as wide

const title_of = ({ name, place }) => (place === '' ? name : `${name} on ${place}`);

/** The names of all lines, in the sequence in which they come: [number] of a colour. */
export function line_names(groups) {
  const charts = groups.flatMap(({ states }) => states.flatMap(({ attachments }) => attachments));
  return [...new Set(charts.flatMap(({ lines }) => (lines ?? []).map(({ name }) => name)))];
}

/** A chart, and below it what its lines are and where they stand. */
function make_curves(curves, measure, names, on_choice) {
  const canvas = element('canvas', { role: 'img' });
  const values = curves.lines.map(() => element('span', { class: 'value' }));
  const strokes = curves.lines.map(() => element('i', {}));
  const entries = curves.lines.map(({ name }, i) => element('li', {}, strokes[i], element('span', {}, name), values[i]));
  const { mark } = curves;
  if (mark) {
    const value = element('span', { class: 'value' }, measure.text(mark.value));
    entries.push(element('li', { class: 'mark' }, element('i', {}), element('span', {}, mark.name), value));
  }
  const title = title_of(curves);
  canvas.setAttribute('aria-label', `Line chart: ${title}, ${curves.y} over ${curves.x}. The values are listed below.`);
  const whole = element(
    'figure',
    { class: 'curves' },
    element('figcaption', {}, element('strong', {}, title), element('span', {}, curves.caption)),
    element('div', { class: 'chart' }, canvas),
    element('ul', { 'aria-label': `${title} at the slider` }, ...entries),
  );
  const numbers = curves.lines.map(({ name }) => names.indexOf(name));
  let chart = null;
  let frame = 0;

  function redraw() {
    numbers.forEach((number, i) => {
      strokes[i].style.borderColor = css_colour(branch_colour(number, is_dark_now()));
    });
    chart?.redraw();
  }

  function set_frame(shown) {
    frame = shown;
    curves.lines.forEach((line, i) => {
      values[i].textContent = measure.text(line.values[frame]);
    });
    chart?.set_frame(frame);
  }

  /** The chart itself is made when it is seen. */
  function show() {
    chart ??= make_curve_chart(canvas, curves, measure, numbers, on_choice);
    chart.set_frame(frame);
  }

  return { whole, show, redraw, set_frame, chart: () => chart, destroy: () => chart?.destroy() };
}

function make_film(film, names) {
  const title = title_of(film);
  const stroke = names.includes(film.name) && element('i', {});
  const caption = element('figcaption', {}, stroke, element('strong', {}, title), element('span', {}, film.caption));
  if (film.pictures.length === 0) {
    const why = 'Not shown: with its pictures the page would be larger than it may be.';
    const whole = element('figure', { class: 'film' }, caption, element('p', { class: 'hint' }, why));
    return { whole, redraw() {}, set_frame() {} };
  }
  const times = Math.max(1, Math.round(usual_width / film.width));
  const size = { width: film.width, height: film.height };
  const image = element('img', { ...size, class: times > 1 && 'enlarged', decoding: 'sync' });
  const width = `width: ${times * film.width}px`;
  const whole = element('figure', { class: 'film', style: width }, image, caption);
  function redraw() {
    if (stroke) stroke.style.borderColor = css_colour(branch_colour(names.indexOf(film.name), is_dark_now()));
  }
  function set_frame(frame) {
    const is_alone = film.frames === 1;
    image.alt = is_alone ? title : `${title}, frame ${frame + 1} of ${film.frames}`;
    image.src = picture(film.pictures[frame]);
  }
  return { whole, redraw, set_frame };
}

/** The input, or what a pipeline made, with what was attached to it. */
function make_state(file, { place, attachments }, is_open, made) {
  const of_kind = (kind) => made.filter((_, i) => attachments[i].kind === kind).map(({ whole }) => whole);
  const [charts, films] = [of_kind('chart'), of_kind('film')];
  const show = () => {
    if (whole.open) for (const one of made) one.show?.();
  };
  const whole = element(
    'details',
    { class: 'state', open: is_open, ontoggle: show },
    element('summary', {}, element('h4', place > 0 ? { 'data-branch': place - 1 } : {}, state_name(file, place))),
    charts.length > 0 && element('div', { class: 'charts' }, ...charts),
    films.length > 0 && element('div', { class: 'films' }, ...films),
  );
  return { whole, show };
}

/**
 * @param {object} file   of the comparison
 * @param {object} group  as the page's JSON has it
 * @param {string[]} names  line_names() of the groups that share their colours
 * @returns {object} `show` is to be called once it is part of the page
 */
export function make_frame_group(file, group, names) {
  const charts = group.states.flatMap(({ attachments }) => attachments.filter(({ kind }) => kind === 'chart'));
  const measure_for = ({ name, unit }) => measure_of(charts.filter((one) => one.name === name && one.unit === unit));
  let frame = 0;
  let began = 0;
  const last = group.frames - 1;
  const a_second = Math.min(frames_a_second, group.frames / least_seconds);
  const player = new Player(
    (seconds) => {
      set_frame(Math.min(last, began + Math.floor(seconds * a_second)));
      return frame < last;
    },
    () => update_row(),
  );
  const chosen = (at) => {
    player.stop();
    set_frame(at);
  };
  const row = slider_row(`Frame of ${group.use}`, `the frames of ${group.use}`, chosen, () => {
    began = frame < last ? frame : 0;
    player.toggle();
  });
  row.whole.hidden = last === 0;

  const made = group.states.map(({ attachments }) =>
    attachments.map((attachment) =>
      attachment.kind === 'chart'
        ? make_curves(attachment, measure_for(attachment), names, chosen)
        : make_film(attachment, names),
    ),
  );
  const parts = made.flat();
  const states = group.states.map((state, i) => make_state(file, state, i < open_states, made[i]));
  const whole = element(
    'div',
    { class: 'frames' },
    element('h3', {}, group.use),
    row.whole,
    ...states.map((state) => state.whole),
  );

  function update_row() {
    row.update(player.is_playing, frame, last, `frame ${frame + 1} of ${group.frames}`);
  }

  function set_frame(shown) {
    frame = shown;
    for (const part of parts) part.set_frame(frame);
    update_row();
  }

  function redraw() {
    for (const part of parts) part.redraw();
  }

  redraw();
  set_frame(0);
  return {
    whole,
    show: () => states.forEach((state) => state.show()),
    redraw,
    set_frame: chosen,
    frame: () => frame,
    charts: () => parts.flatMap((part) => part.chart?.() ?? []),
    destroy() {
      player.stop();
      for (const part of parts) part.destroy?.();
    },
  };
}
