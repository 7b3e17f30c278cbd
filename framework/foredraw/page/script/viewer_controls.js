// What of the viewer can be chosen and pressed, and what its colours mean.

import { heat, ramp } from './colours.js';
import { button, css_colour, element, fill_select, labelled_select, length_text } from './elements.js';
import { short_paths } from './figures.js';
import { modes } from './viewer.js';
import { distance_text } from './viewer_deviation.js';
import { make_drawn_slider, make_level_slider, make_pose_slider } from './viewer_sliders.js';

const mode_names = {
  heat: 'Overdraw',
  shaded: 'Shaded',
  order: 'Triangle order',
  clusters: 'Clusters',
  deviation: 'Deviation',
};

function radio_group(label, name, choices, on_choice) {
  const inputs = new Map(
    choices.map(([value]) => [
      value,
      element('input', { type: 'radio', name, value, onchange: () => on_choice(value) }),
    ]),
  );
  const whole = element(
    'fieldset',
    { class: 'segments' },
    element('legend', {}, label),
    ...choices.map(([value, text]) => element('label', {}, inputs.get(value), element('span', {}, text))),
  );
  return {
    whole,
    choose: (value) => {
      inputs.get(value).checked = true;
    },
  };
}

/** Selects of what is shown: file, subject, the states of both panes. */
function make_selects(viewer) {
  const paths = short_paths(viewer.comparison.files);
  const file = labelled_select(
    'File',
    viewer.scenes.map((scene, i) => ({ value: i, text: paths[scene.file] })),
    (value) => viewer.set_scene(Number(value)),
  );
  const subject = labelled_select('Subject', [], (value) => viewer.set_subject(Number(value)));
  const left = labelled_select('Show', [], (value) => viewer.set_state(0, Number(value)));
  const right = labelled_select('Compare with', [], (value) =>
    viewer.set_state(1, value === 'nothing' ? null : Number(value)),
  );
  file.whole.hidden = viewer.scenes.length < 2;
  let filled = null;

  /** Several subjects may have the same name. */
  const numbered = (name, i, subjects) =>
    subjects.some((other, j) => j !== i && other.name === name) ? `${name} (${i + 1})` : name;

  function update() {
    const key = `${viewer.scene} ${viewer.subject_number}`;
    if (key !== filled) {
      filled = key;
      const { subjects } = viewer.scenes[viewer.scene];
      fill_select(
        subject.select,
        subjects.map(({ name }, i) => ({ value: i, text: numbered(name, i, subjects) })),
      );
      subject.whole.hidden = subjects.length < 2;
      const states = viewer.subject.states.map((state, i) => ({
        value: i,
        disabled: state === null,
        text:
          state === null
            ? `${viewer.state_name(i)} (not shown: ${viewer.subject.absent[i]})`
            : viewer.state_name(i),
      }));
      fill_select(left.select, states);
      fill_select(right.select, [{ value: 'nothing', text: 'nothing' }, ...states]);
    }
    file.select.value = String(viewer.scene);
    subject.select.value = String(viewer.subject_number);
    left.select.value = String(viewer.states[0]);
    right.select.value = viewer.states[1] === null ? 'nothing' : String(viewer.states[1]);
  }

  return { whole: element('div', { class: 'controls' }, file.whole, subject.whole, left.whole, right.whole), update };
}

/** What the colours of the mode mean. */
function make_legend(viewer) {
  const whole = element('div', { class: 'colours' });
  let shown = null;
  const swatch = (colour, text) =>
    element('span', { class: 'swatch' }, element('i', { style: `background: ${css_colour(colour)}` }), text);
  const gradient = Array.from({ length: 9 }, (_, i) => css_colour(ramp(i / 8))).join(', ');

  function content() {
    if (viewer.mode === 'heat') {
      return [
        element('span', {}, 'times a pixel is shaded'),
        ...heat.map((colour, i) => swatch(colour, i + 1 === heat.length ? `${i + 1}+` : String(i + 1))),
      ];
    }
    if (viewer.mode === 'order') {
      return [
        element('span', {}, 'drawn first'),
        element('i', { class: 'ramp', style: `background-image: linear-gradient(to right, ${gradient})` }),
        element('span', {}, 'drawn last'),
      ];
    }
    if (viewer.mode === 'clusters') {
      const without = viewer.shown_panes().filter((pane) => !viewer.shown(pane).has_clusters());
      return [
        element('span', {}, 'one colour per cluster'),
        ...without.map((pane) =>
          element('span', {}, `no clusters in ${viewer.state_name(viewer.states[pane])}: one colour per mesh`),
        ),
      ];
    }
    if (viewer.mode === 'deviation') {
      const bounds = viewer.distance_bounds;
      if (bounds.length === 0) return [element('span', {}, 'no point is away from the surface of the input')];
      return [
        element('span', {}, distance_text(viewer)),
        ...bounds.map((bound, i) =>
          swatch(heat[i], i + 1 === heat.length ? `above ${length_text(bounds[i - 1])}` : `to ${length_text(bound)}`),
        ),
      ];
    }
    const with_wires = viewer.shown_panes().filter((pane) => viewer.shown(pane).has_wires);
    return [
      element('span', {}, 'triangles as they are; back faces where the material is double-sided'),
      ...with_wires.map((pane) =>
        element('span', {}, `wires in ${viewer.state_name(viewer.states[pane])}: by how much of a pixel they cover`),
      ),
    ];
  }

  function update() {
    const key = [viewer.mode, viewer.scene, viewer.subject_number, viewer.level, ...viewer.states].join(' ');
    if (key === shown) return;
    shown = key;
    whole.replaceChildren(...content());
  }
  return { whole, update };
}

/** Puts the viewer's controls around its panes, into `holder`. */
export function add_controls(holder, viewer, panes) {
  const selects = make_selects(viewer);
  const mode = radio_group(
    'Colours',
    'viewer-mode',
    modes.map((value) => [value, mode_names[value]]),
    (value) => viewer.set_mode(value),
  );
  const projection = radio_group(
    'Camera',
    'viewer-camera',
    [
      ['true', 'Orthographic'],
      ['false', 'Perspective'],
    ],
    (value) => viewer.set_orthographic(value === 'true'),
  );
  const worst = button('Worst view', async () => {
    worst.disabled = true;
    worst.textContent = 'Looking …';
    await viewer.show_worst_view().finally(() => {
      worst.textContent = 'Worst view';
      worst.disabled = false;
    });
  });
  worst.title = 'Turns to the one of 100 directions where the first picture has the most fragments per pixel';
  const reset = button('Reset view', () => viewer.reset_camera());
  const legend = make_legend(viewer);
  const drawn = make_drawn_slider(viewer);
  const level = make_level_slider(viewer);
  const pose = make_pose_slider(viewer);
  const note = element('p', { class: 'note' });

  holder.append(
    element(
      'div',
      { class: 'viewer' },
      selects.whole,
      element(
        'div',
        { class: 'controls' },
        mode.whole,
        projection.whole,
        element('div', { class: 'buttons' }, worst, reset),
      ),
      note,
      panes.whole,
      legend.whole,
      drawn.whole,
      level.whole,
      pose.whole,
      element(
        'p',
        { class: 'hint' },
        'Drag to turn, Shift and drag to move; click a picture, then scroll to zoom. ' + 'Keys: arrows, + and -, Home.',
      ),
    ),
  );

  function update() {
    mode.choose(viewer.mode);
    projection.choose(String(viewer.orbit.is_orthographic));
    const { notes } = viewer;
    note.replaceChildren(...notes.map((text) => element('span', {}, `${text}. `)));
    note.hidden = notes.length === 0;
    for (const part of [selects, legend, drawn, level, pose]) part.update();
  }
  viewer.on_change(update);
  update();
}
