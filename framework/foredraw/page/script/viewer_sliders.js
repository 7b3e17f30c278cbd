// What of the viewer can be moved and played: how much is drawn, and the pose.

import { element, fill_select, labelled_select, length_text } from './elements.js';
import { clips_of, Player, pose_at } from './player.js';
import { slider_row } from './slider_row.js';

const drawing_seconds = 6;
const level_seconds = 2; // from one level to the next
const number = new Intl.NumberFormat('en');

/** "5,000 of 5,856"; where both panes are of different sizes, "5,856 of 5,856 and 6,000 of 6,012". */
function drawn_text(viewer) {
  const texts = viewer.shown_panes().map((pane) => {
    const { triangles } = viewer.shown(pane);
    return `${number.format(Math.min(viewer.drawn, triangles))} of ${number.format(triangles)}`;
  });
  return [...new Set(texts)].join(' and ');
}

/** Watch the mesh being drawn. */
export function make_drawn_slider(viewer) {
  let began = 0;
  const player = new Player(
    (seconds) => {
      viewer.set_drawn(began + (seconds / drawing_seconds) * viewer.most_drawn);
      return viewer.drawn < viewer.most_drawn;
    },
    () => update(),
  );
  const row = slider_row(
    'Triangles drawn',
    'the triangles one after another',
    (n) => {
      player.stop();
      viewer.set_drawn(n);
    },
    () => {
      began = viewer.drawn < viewer.most_drawn ? viewer.drawn : 0;
      player.toggle();
    },
  );
  function update() {
    const { drawn, most_drawn } = viewer;
    row.update(player.is_playing, drawn, most_drawn, `triangles drawn: ${drawn_text(viewer)}`);
  }
  return { whole: row.whole, update };
}

/**
 * Of one state: where it is among its levels, what it draws there, and how far that is from full detail at most. What
 * is proved is the distance of surfaces that no joint or morph target moves.
 */
function level_text(viewer, pane) {
  const shown = viewer.shown(pane);
  const { levels } = viewer.subject.states[viewer.states[pane]];
  if (levels === 1) return null;
  const level = levels - shown.levels;
  const way = viewer.way_of(shown);
  const place = way > 0 ? (level + way).toFixed(2) : level;
  const where = level + way === 0 ? 'full detail' : `level ${place} of ${levels - 1}`;
  const unposed = viewer.subject.poses.length > 1 ? ' unposed' : '';
  const error = way === 0 && shown.error > 0 ? `, at most ${length_text(shown.error)} away${unposed}` : '';
  return `${where}: ${number.format(shown.triangles)} triangles${error}`;
}

/** From full detail to the coarsest level; without steps where vertices are known to move from one to the next. */
export function make_level_slider(viewer) {
  let began = 0;
  const player = new Player(
    (seconds) => {
      viewer.set_level(began + seconds / level_seconds);
      return viewer.level < viewer.coarsest_level;
    },
    () => update(),
  );
  const row = slider_row(
    'Level of detail',
    'from full detail to the coarsest level',
    (level) => {
      player.stop();
      viewer.set_level(level);
    },
    () => {
      began = viewer.level < viewer.coarsest_level ? viewer.level : 0;
      player.toggle();
    },
  );
  row.whole.classList.add('levels');
  function update() {
    const { coarsest_level, has_geomorphs } = viewer;
    row.whole.hidden = coarsest_level === 0;
    if (row.whole.hidden) return player.stop();
    const texts = viewer.shown_panes().map((pane) => level_text(viewer, pane));
    const words = [...new Set(texts.filter((text) => text !== null))].join(' and ');
    row.update(player.is_playing, Math.min(viewer.level, coarsest_level), coarsest_level, words, has_geomorphs ? 0.01 : 1);
  }
  return { whole: row.whole, update };
}

/** Poses of one clip: no moment between them, for nobody has measured it. */
export function make_pose_slider(viewer) {
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
