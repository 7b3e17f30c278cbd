// What the report page does beyond being read. It stays readable where any of this fails.

import { start_files } from './files.js';
import { start_frames } from './frames.js';
import { start_highlight } from './highlight.js';
import { read_json } from './page_data.js';
import { start_plot } from './plot.js';
import { start_tables } from './tables.js';
import { start_theme } from './theme.js';
import { start_viewer, viewer_interface } from './viewer_start.js';

const section = (id) => document.getElementById(id);

function remove_excuses(holder) {
  for (const paragraph of holder.querySelectorAll('.without-script')) paragraph.remove();
}

const after_paint = () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));

async function show_viewer(comparison, redraws) {
  const holder = section('viewer');
  const all = read_json('scenes');
  if (holder === null || all === null) return null;
  await after_paint();
  remove_excuses(holder);
  const scenes = all.scenes.filter((scene) => scene.subjects.length > 0);
  const viewer = start_viewer(holder, comparison, scenes);
  if (viewer === null) return null;
  redraws.push(() => viewer.changed());
  await new Promise((resolve) => {
    viewer.first_drawn = resolve;
  });
  performance.mark('viewer-ready');
  return viewer;
}

function start() {
  const redraws = []; // of what does not follow the style sheet by itself
  const comparison = read_json('comparison');
  start_tables();
  start_highlight();
  start_theme(() => redraws.forEach((redraw) => redraw()));
  const page = { files: null, plot: null, frames: null, viewer: null };
  window.foredraw = page;
  if (comparison === null || comparison.files.length === 0) return;
  const file_figures = read_json('file-figures');
  if (section('files') !== null && file_figures !== null) {
    remove_excuses(section('files'));
    page.files = start_files(section('files'), file_figures);
  }
  if (section('plot') !== null) {
    remove_excuses(section('plot'));
    page.plot = start_plot(section('plot'), comparison);
    redraws.push(page.plot.redraw);
  }
  const attachments = read_json('attachments');
  if (section('frames') !== null && attachments !== null) {
    remove_excuses(section('frames'));
    page.frames = start_frames(section('frames'), comparison, attachments.groups);
    redraws.push(page.frames.redraw);
  }
  const started = show_viewer(comparison, redraws);
  const ready = started.then((viewer) => {
    if (viewer !== null) Object.assign(page.viewer, viewer_interface(viewer, ready));
    return viewer !== null;
  });
  page.viewer = { ready };
}

start();
