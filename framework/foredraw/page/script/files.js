// Thousands of files: one figure of all of them as a histogram, and a table of which the rows in sight alone are there.

import { button, element, labelled_select } from './elements.js';

const row_height = 32; // as in the style sheet
const rows_around = 8; // that stand ready above and below
const most_bars = 40;
const by_text = new Intl.Collator('en', { numeric: true, sensitivity: 'base' });

/** What can be asked of a figure: each state's value, and by how much each state differs from the input. */
function columns_of(states) {
  const values = states.map((name, state) => ({ key: `value-${state}`, name, state, is_change: false }));
  const changes = states.slice(1).map((name, i) => ({
    key: `change-${i + 1}`,
    name: `${name.split(' ')[0]} change`,
    state: i + 1,
    is_change: true,
  }));
  return [...values, ...changes];
}

function value_at(figure, column, file) {
  const value = figure.values[column.state][file];
  if (!column.is_change) return value;
  const input = figure.values[0][file];
  if (value === null || input === null) return null;
  if (value === input) return 0;
  return input === 0 ? null : (value - input) / Math.abs(input);
}

function text_of(value, figure, column) {
  if (value === null) return '-';
  if (column.is_change) return `${value > 0 ? '+' : ''}${(100 * value).toFixed(1)} %`;
  return figure['is-count'] ? String(value) : value.toFixed(4);
}

/** [{from, to, count, holds}]: equal steps from the least to the most value, but for the outermost hundredths, which the outer bars take in. */
function bars_of(values) {
  const sorted = values.filter((value) => value !== null).sort((a, b) => a - b);
  if (sorted.length === 0) return [];
  const outer = Math.floor(sorted.length / 100);
  const [least, most] = [sorted[outer], sorted[sorted.length - 1 - outer]];
  if (least === most && sorted[0] === sorted[sorted.length - 1]) {
    return [{ from: least, to: most, count: sorted.length, holds: () => true }];
  }
  const step = (most - least) / most_bars || 1;
  const bars = Array.from({ length: most_bars }, (_, i) => ({
    from: i === 0 ? sorted[0] : least + i * step,
    to: i === most_bars - 1 ? sorted[sorted.length - 1] : least + (i + 1) * step,
    count: 0,
    holds: (value) => bar_of(value, least, step) === i,
  }));
  for (const value of sorted) ++bars[bar_of(value, least, step)].count;
  return bars;
}

const bar_of = (value, least, step) => Math.min(most_bars - 1, Math.max(0, Math.floor((value - least) / step)));

/**
 * Fills the section from the figures of all files.
 * @returns {object} what tests may use
 */
export function start_files(holder, data) {
  const columns = columns_of(data.states);
  const state = { figure: data.figures[0], shown: columns.at(-1), sorted: null, range: null, rows: [] };
  if (data.figures.length === 0) {
    holder.append(element('p', {}, 'Nothing was measured.'));
    return { rows: () => [] };
  }

  const figure_select = labelled_select(
    'Figure',
    data.figures.map((figure, i) => ({
      value: String(i),
      text: figure.unit ? `${figure.metric} (${figure.unit})` : figure.metric,
      group: figure.evaluator,
    })),
    (value) => set_figure(Number(value)),
  );
  const shown_select = labelled_select(
    'Histogram of',
    columns.map(({ key, name }) => ({ value: key, text: name })),
    (value) => set_shown(value),
  );
  const box = element('input', {
    type: 'search',
    placeholder: 'Filter files',
    'aria-label': 'Filter files',
    spellcheck: 'false',
    oninput: choose_rows,
  });
  const count = element('output', { class: 'count' });
  const bars = element('div', { class: 'bars', role: 'group', 'aria-label': 'Histogram' });
  const axis = element('div', { class: 'bar-axis' });
  const body = element('tbody');
  const heads = [{ key: 'file', name: 'file' }, ...columns].map((column) => ({
    column,
    cell: element(
      'th',
      { class: column.key === 'file' ? null : 'number' },
      element('button', { type: 'button', class: 'sort', onclick: () => sort_by(column.key) }, column.name),
    ),
  }));
  const table = element(
    'table',
    { 'aria-rowcount': data.files.length + 1 },
    element('thead', {}, element('tr', {}, ...heads.map(({ cell }) => cell))),
    body,
  );
  const above = element('tr', { class: 'space', 'aria-hidden': 'true' }, element('td', { colspan: heads.length }));
  const below = above.cloneNode(true);
  const scroll = element('div', { class: 'scroll rows', onscroll: fill }, table);
  holder.append(
    element('div', { class: 'controls' }, figure_select.whole, shown_select.whole),
    bars,
    axis,
    element('div', { class: 'filter' }, box, count),
    scroll,
  );

  /** Numbers of files: those that the box and the bar leave, as they are sorted; what has no figure comes last. */
  function choose_rows() {
    const words = box.value.trim().toLowerCase().split(/\s+/);
    const { figure, range, shown } = state;
    const rows = [];
    data.files.forEach((name, file) => {
      const text = name.toLowerCase();
      if (!words.every((word) => text.includes(word))) return;
      const value = range === null ? null : value_at(figure, shown, file);
      if (range !== null && (value === null || !range.holds(value))) return;
      rows.push(file);
    });
    if (state.sorted !== null) {
      const { key, direction } = state.sorted;
      const column = columns.find((one) => one.key === key);
      const keys = new Map(rows.map((file) => [file, column ? value_at(figure, column, file) : data.files[file]]));
      const compare = column ? (a, b) => a - b : by_text.compare;
      rows.sort((a, b) => {
        const [x, y] = [keys.get(a), keys.get(b)];
        if (x === null || y === null) return (x === null) - (y === null) || a - b;
        return direction * compare(x, y) || a - b;
      });
    }
    state.rows = rows;
    const all = data.files.length;
    count.textContent = rows.length === all ? `${all} files` : `${rows.length} of ${all} files`;
    scroll.scrollTop = 0;
    fill();
  }

  function row_of(file, place) {
    const { figure } = state;
    const cells = columns.map((column) => {
      const value = value_at(figure, column, file);
      const is_better = value < 0 === figure['lower-is-better'];
      const change = column.is_change && value ? (is_better ? ' change better' : ' change worse') : '';
      return element('td', { class: `number${change}` }, text_of(value, figure, column));
    });
    return element(
      'tr',
      { 'aria-rowindex': place + 2 },
      element('td', { title: data.files[file] }, data.files[file]),
      ...cells,
    );
  }

  /** The rows in sight, between two that are as high as all the others. */
  function fill() {
    const all = state.rows.length;
    const first = Math.max(0, Math.min(Math.floor(scroll.scrollTop / row_height) - rows_around, all - 1));
    const end = Math.min(all, first + Math.ceil(scroll.clientHeight / row_height) + 2 * rows_around);
    above.cells[0].style.height = `${first * row_height}px`;
    below.cells[0].style.height = `${(all - end) * row_height}px`;
    above.hidden = first === 0;
    below.hidden = end === all;
    body.replaceChildren(above, ...state.rows.slice(first, end).map((file, i) => row_of(file, first + i)), below);
  }

  function draw_bars() {
    const { figure, shown } = state;
    const found = bars_of(data.files.map((_, file) => value_at(figure, shown, file)));
    const most = Math.max(1, ...found.map((bar) => bar.count));
    const text = (value) => text_of(value, figure, shown);
    bars.replaceChildren(
      ...found.map((bar) => {
        const told = `${bar.count} files: ${text(bar.from)} to ${text(bar.to)}`;
        const one = button('', () => set_range(one, bar));
        one.className = 'bar';
        one.title = told;
        one.setAttribute('aria-label', told);
        one.setAttribute('aria-pressed', 'false');
        one.append(element('span', { style: `height: ${((100 * bar.count) / most).toFixed(2)}%` }));
        return one;
      }),
    );
    const ends = found.length === 0 ? [] : [found[0].from, found[found.length - 1].to];
    axis.replaceChildren(...ends.map((value) => element('span', {}, text(value))));
  }

  /** The files of one bar; of the same one again, all. */
  function set_range(pressed, bar) {
    const was = pressed.getAttribute('aria-pressed') === 'true';
    for (const one of bars.children) one.setAttribute('aria-pressed', String(one === pressed && !was));
    state.range = was ? null : bar;
    choose_rows();
  }

  function sort_by(key) {
    const was = state.sorted?.key === key ? state.sorted.direction : 0;
    state.sorted = was === 0 ? { key, direction: 1 } : was === 1 ? { key, direction: -1 } : null;
    show_sorting();
    choose_rows();
  }

  function show_sorting() {
    for (const { column, cell } of heads) {
      if (state.sorted?.key !== column.key) cell.removeAttribute('aria-sort');
      else cell.setAttribute('aria-sort', state.sorted.direction === 1 ? 'ascending' : 'descending');
    }
  }

  /** The worst first. */
  function sort_by_change() {
    const change = columns.find((column) => column.is_change);
    state.sorted = change ? { key: change.key, direction: state.figure['lower-is-better'] ? -1 : 1 } : null;
    show_sorting();
  }

  function set_shown(key) {
    state.shown = columns.find((column) => column.key === key);
    state.range = null;
    shown_select.select.value = key;
    draw_bars();
    choose_rows();
  }

  function set_figure(number) {
    state.figure = data.figures[number];
    figure_select.select.value = String(number);
    sort_by_change();
    set_shown(state.shown.key);
  }

  state.shown = columns.find((column) => column.is_change) ?? columns[0];
  set_figure(0);
  new ResizeObserver(fill).observe(scroll);
  performance.mark('files-ready');
  return { rows: () => state.rows.map((file) => data.files[file]), set_figure, set_shown, sort_by };
}
