// Everything of the viewer that can be chosen, pressed or moved.

import { heat, ramp } from './colours.js';
import { css_colour, element, fill_select, labelled_select } from './elements.js';
import { short_paths } from './figures.js';
import { clips_of, Player, pose_at } from './player.js';
import { modes } from './viewer.js';

const mode_names = { heat: 'Overdraw', shaded: 'Shaded', order: 'Triangle order', clusters: 'Clusters' };
const drawing_seconds = 6;
const number = new Intl.NumberFormat('en');

const button = (text, onclick) => element('button', { type: 'button', onclick }, text);

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

  function update() {
    const key = `${viewer.scene} ${viewer.subject_number}`;
    if (key !== filled) {
      filled = key;
      const { subjects } = viewer.scenes[viewer.scene];
      fill_select(
        subject.select,
        subjects.map(({ name }, i) => ({ value: i, text: name })),
      );
      subject.whole.hidden = subjects.length < 2;
      const states = viewer.subject.states.map((state, i) => ({
        value: i,
        disabled: state === null,
        text:
          state === null ? `${viewer.state_name(i)}: ${viewer.subject.absent[i] ?? 'not shown'}` : viewer.state_name(i),
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

/** A slider with a play button before and a text behind it. */
function slider_row(label, player_label, on_input, on_play) {
  const play = button('Play', on_play);
  const slider = element('input', {
    type: 'range',
    min: 0,
    step: 1,
    'aria-label': label,
    oninput: () => on_input(Number(slider.value)),
  });
  const text = element('output', {});
  const whole = element('div', { class: 'slider' }, play, slider, text);
  function update(is_playing, value, most, words) {
    play.textContent = is_playing ? 'Pause' : 'Play';
    play.setAttribute('aria-label', `${is_playing ? 'Pause' : 'Play'}: ${player_label}`);
    slider.max = String(most);
    slider.value = String(value);
    slider.setAttribute('aria-valuetext', words);
    text.textContent = words;
  }
  return { whole, play, update };
}

/** Watch the mesh being drawn. */
function make_drawn_slider(viewer) {
  let began = 0;
  const player = new Player(
    (seconds) => {
      viewer.set_drawn(began + (seconds / drawing_seconds) * viewer.subject.triangles);
      return viewer.drawn < viewer.subject.triangles;
    },
    () => update(),
  );
  const row = slider_row(
    'Triangles drawn',
    'the triangles, one after the other',
    (n) => {
      player.stop();
      viewer.set_drawn(n);
    },
    () => {
      began = viewer.drawn < viewer.subject.triangles ? viewer.drawn : 0;
      player.toggle();
    },
  );
  function update() {
    const { drawn, subject } = viewer;
    row.update(
      player.is_playing,
      drawn,
      subject.triangles,
      `triangles drawn: ${number.format(drawn)} of ${number.format(subject.triangles)}`,
    );
  }
  return { whole: row.whole, update };
}

/** Poses of one clip: no moment between them, for nobody has measured it. */
function make_pose_slider(viewer) {
  let clips = [];
  let of_subject = null;
  const clip_now = () => clips.find(({ poses }) => poses.includes(viewer.pose)) ?? clips[0];
  let began = 0;
  const player = new Player(
    (seconds) => {
      const pose = pose_at(clip_now(), viewer.subject.poses, began + seconds);
      if (pose !== viewer.pose) viewer.set_pose(pose);
    },
    () => update(),
  );
  const clip_select = labelled_select('Clip', [], (i) => {
    player.stop();
    viewer.set_pose(clips[Number(i)].poses[0]);
  });
  const row = slider_row(
    'Pose',
    'the poses of the clip',
    (i) => {
      player.stop();
      viewer.set_pose(clip_now().poses[i]);
    },
    () => {
      const { poses } = viewer.subject;
      began = poses[viewer.pose].time - poses[clip_now().poses[0]].time;
      player.toggle();
    },
  );
  const whole = element('div', { class: 'poses' }, clip_select.whole, row.whole);

  function update() {
    if (of_subject !== viewer.subject) {
      of_subject = viewer.subject;
      clips = clips_of(viewer.subject.poses);
      player.stop();
      fill_select(
        clip_select.select,
        clips.map(({ name }, i) => ({ value: i, text: name ?? 'at rest' })),
      );
      clip_select.whole.hidden = clips.length < 2;
      whole.hidden = viewer.subject.poses.length < 2;
    }
    const clip = clip_now();
    const place = clip.poses.indexOf(viewer.pose);
    clip_select.select.value = String(clips.indexOf(clip));
    row.whole.hidden = clip.poses.length < 2;
    row.update(
      player.is_playing,
      place,
      clip.poses.length - 1,
      `pose ${place + 1} of ${clip.poses.length}, ${viewer.subject.poses[viewer.pose].time.toFixed(3)} s`,
    );
  }
  return { whole, update };
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
      const without = viewer.shown_panes().filter((pane) => !viewer.subject.has_clusters(viewer.states[pane]));
      return [
        element('span', {}, 'one colour for each cluster'),
        ...without.map((pane) =>
          element('span', {}, `no clusters in ${viewer.state_name(viewer.states[pane])}: one colour for each mesh`),
        ),
      ];
    }
    return [element('span', {}, 'triangles as they are, both sides')];
  }

  function update() {
    const key = `${viewer.mode} ${viewer.mode === 'clusters' ? `${viewer.states} ${viewer.scene} ${viewer.subject_number}` : ''}`;
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
    await viewer.show_worst_view();
    worst.textContent = 'Worst view';
    worst.disabled = false;
  });
  worst.title = 'Turns to where what is shown first has the most fragments per pixel, of 100 directions';
  const reset = button('Reset view', () => viewer.reset_camera());
  const legend = make_legend(viewer);
  const drawn = make_drawn_slider(viewer);
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
    note.textContent = viewer.subject.note;
    note.hidden = viewer.subject.note === '';
    for (const part of [selects, legend, drawn, pose]) part.update();
  }
  viewer.on_change(update);
  update();
}
