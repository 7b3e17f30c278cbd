// The plot of branches over any two figures, with what chooses them and what tells the same in words.

import { element, fill_select, labelled_select } from './elements.js';
import { axes_of, axis_title, default_axes, figure_text, short_paths, state_name } from './figures.js';
import { highlight, on_highlight, pin } from './highlight.js';
import { pareto_front } from './pareto.js';
import { make_chart } from './plot_chart.js';

const axis_choices = (axes) =>
  axes.map((axis) => ({
    value: axis.key,
    text: axis.unit ? `${axis.name} (${axis.unit})` : axis.name,
    group: axis.group,
  }));

/** What can be plotted: all files as one, where there are several, and each of them, by the page's names for them. */
function plotted_files(comparison) {
  const names = short_paths(comparison.files);
  const files = comparison.files
    .map((file, i) => [String(i), { name: names[i], file }])
    .filter(([, { file }]) => file.metrics.length > 0); // times alone are nothing to weigh against
  return new Map(
    comparison.all ? [['all', { name: comparison.all.input.path, file: comparison.all }], ...files] : files,
  );
}

/**
 * Fills the section `holder` from the comparison.
 * @returns {object} what tests and the page may use
 */
export function start_plot(holder, comparison) {
  const files = plotted_files(comparison);
  if (files.size === 0) {
    holder.append(element('p', {}, 'Nothing was measured that could be plotted.'));
    return { redraw() {} };
  }
  const state = { file: null, axes: [], x: null, y: null, is_log: false, highlighted: null };
  const canvas = element('canvas', { role: 'img' });
  const legend = element('ol', { class: 'legend' });
  const front_line = element('p', { class: 'front', 'aria-live': 'polite' });
  const file_select = labelled_select(
    'File',
    [...files].map(([value, { name }]) => ({ value, text: name })),
    (value) => set_file(value),
  );
  const x_select = labelled_select('Across', [], (key) => set_axes(key, state.y.key));
  const y_select = labelled_select('Upwards', [], (key) => set_axes(state.x.key, key));
  const log_box = element('input', { type: 'checkbox', onchange: () => set_log(log_box.checked) });
  const article = element(
    'article',
    { class: 'plot' },
    element(
      'div',
      { class: 'controls' },
      files.size > 1 && file_select.whole,
      x_select.whole,
      y_select.whole,
      element('label', { class: 'check' }, log_box, ' logarithmic across'),
    ),
    element('div', { class: 'chart' }, canvas),
    legend,
    front_line,
  );
  holder.append(article);

  const branch_of = (place) => (place === null || place === 0 ? null : { file: state.file, branch: place - 1 });
  const chart = make_chart(
    canvas,
    (place) => highlight(branch_of(place)),
    (place) => place > 0 && pin(branch_of(place)),
  );
  canvas.addEventListener('pointerleave', () => highlight(null));

  const file = () => files.get(state.file).file;

  /** The places that have both figures, above 0 where the scale asks for it. */
  function places() {
    return state.x.values.flatMap((x, place) =>
      Number.isFinite(x) && Number.isFinite(state.y.values[place]) && (!state.is_log || x > 0) ? [place] : [],
    );
  }

  /** The branches that no other one beats in both; the input is not among those that are judged. */
  function front() {
    const { x, y } = state;
    const judged = places().filter((place) => place > 0);
    const better = (axis, place) => (axis.less_is_better ? 1 : -1) * axis.values[place];
    return pareto_front(judged.map((place) => [better(x, place), better(y, place)])).map((i) => judged[i]);
  }

  function redraw() {
    chart.draw({ ...state, file: file(), places: places(), front: front() });
  }

  function fill_legend() {
    const entry = (place) =>
      element(
        'li',
        place > 0 ? { 'data-branch': place - 1 } : {},
        element('button', { type: 'button', 'data-branch': place > 0 ? place - 1 : null }, state_name(file(), place)),
        element('span', { class: 'values' }, `${figure_text(state.x, place)}, ${figure_text(state.y, place)}`),
      );
    legend.replaceChildren(...places().map(entry));
  }

  /** Nothing of a single pipeline: it has no rivals. */
  function front_text(names, two, corner) {
    if (names.length === 0) return `No pipeline has both ${two}${state.is_log ? ' above 0' : ''}.`;
    if (file().branches.length < 2) return '';
    const where = names.length > 1 ? `The line joins them; ${corner}` : `${corner[0].toUpperCase()}${corner.slice(1)}`;
    return `No other pipeline is better in both ${two}: ${names.join(' ')}. ${where} is better.`;
  }

  function changed() {
    const { x, y } = state;
    fill_legend();
    const names = front().map((place) => `[${place}]`);
    const two = `${axis_title(x)} and ${axis_title(y)}`;
    const corner = `${y.less_is_better ? 'lower' : 'upper'} ${x.less_is_better ? 'left' : 'right'}`;
    front_line.textContent = front_text(names, two, corner);
    front_line.hidden = front_line.textContent === '';
    canvas.setAttribute('aria-label', `Scatter plot of ${two}. The list below holds the same figures.`);
    redraw();
  }

  function set_axes(x, y) {
    const find = (key) => state.axes.find((axis) => axis.key === key) ?? state.axes[0];
    [state.x, state.y] = [find(x), find(y)];
    [x_select.select.value, y_select.select.value] = [state.x.key, state.y.key];
    changed();
  }

  function set_file(key) {
    const kept = state.x === null ? null : [state.x.key, state.y.key];
    state.file = key;
    state.axes = axes_of(file());
    article.dataset.file = key;
    file_select.select.value = key;
    for (const { select } of [x_select, y_select]) fill_select(select, axis_choices(state.axes));
    set_axes(...(kept ?? default_axes(state.axes)));
  }

  function set_log(is_log) {
    state.is_log = is_log;
    log_box.checked = is_log;
    changed();
  }

  on_highlight((what) => {
    state.highlighted = what?.file === state.file ? what.branch + 1 : null;
    redraw();
    chart.point_out(state.highlighted);
  });
  set_file([...files.keys()][0]);

  return {
    axes: () => state.axes.map((axis) => axis.key),
    chosen: () => [state.x.key, state.y.key],
    /** [place, x, y]: place 0 is the input, place i + 1 branch i. */
    points: () => places().map((place) => [place, state.x.values[place], state.y.values[place]]),
    set_axes,
    set_file,
    set_log,
    front,
    redraw,
    tooltip: chart.tooltip,
    positions: chart.positions,
  };
}
