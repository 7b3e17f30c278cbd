// The section of pictures and curves that techniques attached, of one file at a time.

import { element, labelled_select } from './elements.js';
import { short_paths } from './figures.js';
import { line_names, make_frame_group } from './frame_group.js';

/**
 * Fills the section `holder`. `groups`: of all files.
 * @returns {object} what tests and the page may use
 */
export function start_frames(holder, comparison, groups) {
  const paths = short_paths(comparison.files);
  const files = [...new Set(groups.map(({ file }) => file))];
  const select = labelled_select(
    'File',
    files.map((file) => ({ value: file, text: paths[file] })),
    (file) => set_file(Number(file)),
  );
  const article = element('article', {});
  holder.append(files.length > 1 ? element('div', { class: 'controls' }, select.whole) : '', article);
  let shown = [];

  function set_file(file) {
    for (const group of shown) group.destroy();
    const of_file = groups.filter((group) => group.file === file);
    shown = of_file.map((group) =>
      make_frame_group(comparison.files[file], group, line_names(of_file.filter(({ use }) => use === group.use))),
    );
    select.select.value = String(file);
    article.dataset.file = String(file);
    article.replaceChildren(...shown.map(({ whole }) => whole));
    for (const group of shown) group.show();
  }

  set_file(files[0]);
  return {
    set_file,
    redraw: () => shown.forEach((group) => group.redraw()),
    set_frame: (group, frame) => shown[group].set_frame(frame),
    frame: (group) => shown[group].frame(),
    /** Where a frame and a value are in a chart, [x, y] in pixels of its canvas. */
    position: (group, chart, frame, value) => shown[group].charts()[chart].position(frame, value),
    tooltip: (group, chart) => shown[group].charts()[chart].tooltip(),
  };
}
