// The report page in a browser: node pages.mjs PROGRAM CORPUS OUTPUT_FOLDER PROGRAM_WITH_WALK [--only=GROUP,...]
// Makes pages with the program and looks at them, and with one that has the evaluator of walk.cpp. Pictures of them are
// left in the folder.
// Exit 77 where the program was built without the page's script, 1 where a check failed.

import { mkdirSync, statSync } from 'node:fs';
import path from 'node:path';
import { launch, open, settled } from './browser.mjs';
import { check, check_equal, exit_code, group } from './checks.mjs';
import { check_files, write_strips } from './file_checks.mjs';
import { check_frames, check_frames_of_files, check_no_frames } from './frame_checks.mjs';
import { check_deviation, check_levels, check_no_levels, check_pops } from './level_checks.mjs';
import { check_colours, check_paper, check_widths, check_without_gl, check_without_script } from './look_checks.mjs';
import { rectangles, tube, write_gltf } from './models.mjs';
import {
  check_pose_ratios,
  check_ratios,
  check_stacks,
  check_table_ratios,
  write_stacks,
} from './overdraw_checks.mjs';
import { check_plot } from './plot_checks.mjs';
import { Program } from './program.mjs';
import {
  check_figures,
  check_filter,
  check_highlight,
  check_highlight_of_one_file,
  check_sorting,
} from './table_checks.mjs';
import {
  check_drawn,
  check_keyboard,
  check_modes,
  check_panes,
  check_poses,
  check_table,
  check_unlike_states,
  check_worst_view,
  counted,
  viewer,
} from './viewer_checks.mjs';
import { check_rigging, check_thin_tubes } from './wire_checks.mjs';

const [program_path, corpus, folder, walking_path] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const program = new Program(program_path, folder);
const spot = path.join(corpus, 'static', 'spot.glb');
const pipelines = ['tipsify', 'lookahead', '@default', 'lookahead, linear-clusters(growth=1.3), dot-rule'];

const made = program.compare('spot', [spot], pipelines);
if (made.scenes === null) {
  console.log('skipped: the program was built without the script of its page');
  process.exit(77);
}
const browser = await launch();

/** A page of its own for a group of checks; what it complains of or asks for is one of them. */
async function on_page(name, html, run) {
  await group(name, async () => {
    const { page, complaints, requests } = await open(browser, html);
    await run(page);
    check(`${name}: the console is silent`, complaints.length === 0, complaints);
    check(`${name}: nothing is asked for beside the file`, requests.length === 0, requests);
    await page.close();
  });
}

await on_page('tables', made.html, async (page) => {
  await check_figures(page, made.comparison);
  await check_sorting(page);
  await check_highlight(page);
});

await on_page('plot', made.html, (page) => check_plot(page, made.comparison));

await group('frames', async () => {
  await on_page('nothing attached', made.html, check_no_frames);
  const walking = new Program(walking_path, folder);
  const more = ['--with', 'vertex-cache, walk'];
  const fewer = ['tipsify', 'weld, quadric-collapse, simplify(ratio=0.5)'];
  const { html, comparison } = walking.compare('frames', [spot], fewer, { more });
  await on_page('films and charts', html, (page) => check_frames(page, comparison, folder));
  const house = path.join(corpus, 'scenes', 'house.glb');
  const two = walking.compare('frames-two', [house, spot], ['tipsify'], { more });
  await on_page('films and charts of two files', two.html, (page) => check_frames_of_files(page, two.comparison));
});

await on_page('viewer', made.html, async (page) => {
  await check_modes(page);
  await check_panes(page);
  await check_drawn(page, program.remap(spot, pipelines[0]), pipelines[0]);
  await check_keyboard(page);
  await check_worst_view(page, made.comparison);
  const picture = async (name) => {
    await counted(page);
    await page.locator('#viewer .viewer').screenshot({ path: path.join(folder, name) });
  };
  await viewer(page, 'set_direction', [-0.5, 0.25, 0.8]);
  await picture('viewer-pair.png');
  await viewer(page, 'set_state', 1, null);
  await picture('viewer-heat.png');
});

await group('overdraw of rectangles', () =>
  on_page('stacks', program.compare('stacks', write_stacks(folder), ['tipsify']).html, check_stacks),
);

await on_page('overdraw of a model', made.html, (page) =>
  check_ratios(page, program, spot, { subjects: made.scenes[0].subjects.length }),
);

// A double-sided draw becomes single-sided, and some of its triangles are copied.
await group('sides', async () => {
  const helmet = path.join(corpus, 'static', 'flight_helmet_notex.glb');
  const directions = 20; // by default 100, which take half a minute where no GPU draws them
  const more = ['--with', `overdraw-raster(count=${directions})`];
  const { html, comparison, scenes } = program.compare('helmet', [helmet], ['@default'], { more });
  const subjects = scenes[0].subjects.length;
  await on_page('a double-sided draw from all sides', html, (page) =>
    check_table_ratios(page, comparison.files[0], { subjects, directions }),
  );
});

// Draws are drawn in another sequence as well.
await group('sequence', async () => {
  const knight = path.join(corpus, 'animated', 'kaykit_knight.glb');
  const { html, scenes } = program.compare('knight', [knight], ['tipsify', '@default']);
  const [{ geometries, states, poses }] = scenes[0].subjects;
  check_equal(
    'sequence: a reordered state shares what the input shows, another one has its own',
    states.map(({ geometry }) => geometry),
    [0, 0, 1],
  );
  const names = geometries.map(({ parts }) => parts.map(({ name }) => name));
  check(
    'sequence: the draws come in another sequence',
    JSON.stringify(names[0]) !== JSON.stringify(names[1]) &&
      JSON.stringify(names[0].toSorted()) === JSON.stringify(names[1].toSorted()),
    names,
  );
  await on_page('a character of many draws', html, async (page) => {
    await check_pose_ratios(page, program, knight, poses, { tolerance: 0.015 });
    const optimized = program.optimized(knight, '@default');
    await check_pose_ratios(page, program, optimized, poses, { state: 2, tolerance: 0.015 });
    await check_unlike_states(page);
  });
});

await group('a character', async () => {
  const fox = path.join(corpus, 'animated', 'fox.glb');
  const { html, scenes } = program.compare('fox', [fox], ['@character']);
  await on_page('poses', html, async (page) => {
    await check_table(page, html, scenes);
    await check_poses(page);
    await check_pose_ratios(page, program, fox, scenes[0].subjects[0].poses);
  });
});

// Levels of detail, and what vertices become from one to the next.
await group('levels', async () => {
  const levels = ['weld, quadric-collapse, levels', 'weld, quadric-collapse, levels(keep-sequences=true), geomorphs'];
  const more = ['--with', 'vertex-cache'];
  const fox = path.join(corpus, 'animated', 'fox.glb');
  const { html, comparison } = program.compare('levels', [fox], levels, { more });
  const [draw] = comparison.files[0].branches[0].report.draws;
  await on_page('levels of a character', html, async (page) => {
    await check_no_levels(page);
    await check_levels(page, [draw, ...draw.levels], { step: 1 });
    await viewer(page, 'set_state', 1, 2);
    await check_levels(page, [draw, ...draw.levels], { step: 0.01 });
    await check_pops(page, 'fox.glb', draw.levels.length);
    for (const mode of ['shaded', 'deviation']) {
      await viewer(page, 'set_mode', mode);
      await viewer(page, 'set_level', 2.5);
      await settled(page);
      await page.locator('#viewer .viewer').screenshot({ path: path.join(folder, `levels-${mode}.png`) });
    }
  });
  const knight = path.join(corpus, 'animated', 'kaykit_knight.glb');
  await on_page('levels of many draws', program.compare('levels-knight', [knight], levels, { more }).html, (page) =>
    check_pops(page, 'kaykit_knight.glb', 3),
  );
  // All vertices that are left lie on the input: what is away from it is between them.
  const fewer = 'weld, quadric-collapse(placement=endpoint), simplify(ratio=0.1)';
  const simplified = program.compare('simplified', [spot], [fewer], { more: ['--with', 'surface-error'] });
  await on_page('a simplified model', simplified.html, (page) => check_deviation(page, simplified.comparison));
});

// Wires are drawn by how much of a pixel they cover.
await group('wires', async () => {
  const hanging = (y, scale = [1, 1, 1]) =>
    Array.from({ length: 12 }, (_, i) => [i / 5.5 - 1, y + 0.15 * (i / 5.5 - 1) ** 2, 0.1 * y]).map((place) =>
      place.map((x, axis) => x / Math.abs(scale[axis])),
    );
  const model = write_gltf(path.join(folder, 'tubes.gltf'), [
    { name: 'plain', ...tube(hanging(0.6), 0.0008) },
    { name: 'larger', ...tube(hanging(0.03, [10, 10, 10]), 0.00008), scale: [10, 10, 10] },
    { name: 'uneven', ...tube(hanging(-0.3, [1, 1, 2]), 0.0005), scale: [1, 1, 2] },
    { name: 'mirrored', ...tube(hanging(-0.7), 0.0008), scale: [-1, 1, 1] },
  ]);
  const more = ['--set', 'subjects.subject=scene', '--with', 'vertex-cache'];
  const { html, scenes } = program.compare('tubes', [model], ['wire-radius', 'tipsify'], { more });
  const { states } = scenes[0].subjects[0];
  check_equal('wires: only what has some holds them', states.map((state) => 'wires' in state), [false, true, false]);
  await on_page('thin tubes', html, check_thin_tubes);
  const ship = path.join(corpus, 'static', 'dutch_ship_medium_notex.glb');
  const rigged = program.compare('ship', [ship], ['wire-radius'], { more });
  await on_page('the rigging of a ship', rigged.html, async (page) => {
    await check_rigging(page);
    await page.locator('#viewer .viewer').screenshot({ path: path.join(folder, 'ship.png') });
  });
});

await group('many files', async () => {
  const house = path.join(corpus, 'scenes', 'house.glb');
  const { html, comparison } = program.compare('two', [house, spot], ['tipsify', '@default']);
  await on_page('two files', html, async (page) => {
    await check_figures(page, comparison);
    await check_highlight_of_one_file(page);
    const plotted = async () => (await page.evaluate(() => window.foredraw.plot.points())).map(([, , y]) => y);
    const ratios = ({ metrics }) => metrics.find(({ metric }) => metric === 'ratio').values;
    check_equal('two files: the plot begins with both as one', await plotted(), ratios(comparison.all));
    await page.selectOption('#plot label:has-text("File") select', '1');
    check_equal('two files: the plot shows the other one', await plotted(), ratios(comparison.files[1]));
    await page.selectOption('#viewer label:has-text("File") select', '1');
    check_equal(
      'two files: the viewer shows the other one',
      await viewer(page, 'triangles'),
      comparison.files[1].branches[0].report.totals.triangles,
    );
  });
});

await group('names', async () => {
  const markup = '<img src=x onerror="window.harmed=1">';
  const model = write_gltf(path.join(folder, '<img src=x onerror=window.harmed=1>.gltf'), [
    { name: markup, ...rectangles([-1, -1, 1, 1, 0]) },
    { name: `</script>${markup}`, ...rectangles([-1, -1, 1, 1, 0]) },
    ...Array.from({ length: 30 }, (_, i) => ({ name: `${markup} ${i}`, ...rectangles([i, 0, i + 1, 1, 0]) })),
  ]);
  const { html } = program.compare('names', [model], ['tipsify', 'lookahead']);
  await on_page('names with markup', html, async (page) => {
    check_equal('names: nothing runs', await page.evaluate(() => [window.harmed ?? null, document.images.length]), [
      null,
      0,
    ]);
    const texts = await page.$$eval('#viewer label:has-text("Subject") option', (options) =>
      options.map((o) => o.textContent),
    );
    check(
      'names: shown as they are',
      texts.some((text) => text.includes(markup)),
      texts.slice(0, 3),
    );
    check('names: the file as well', (await page.textContent('#figures h3')).includes('<img src=x onerror='));
    await check_filter(page, '#draws table');
  });
});

await group('little to show', async () => {
  const glass = write_gltf(path.join(folder, 'glass.gltf'), [{ name: 'pane', ...rectangles([-1, -1, 1, 1, 0]) }], {
    alphaMode: 'BLEND',
  });
  await on_page(
    'a model without opaque triangles',
    program.compare('glass', [glass], ['tipsify']).html,
    async (page) => {
      const said = await page.textContent('#viewer');
      check('little to show: the viewer says so', said.includes('no triangles') && !said.includes('has not run'), said);
    },
  );
  const { html } = program.compare('lost', [spot], ['tipsify', 'dot-rule'], { exit_code: 1 });
  await on_page('a pipeline that could not be planned', html, async (page) => {
    check_equal('lost: it is no point', (await page.evaluate(() => window.foredraw.plot.points())).length, 1);
    const disabled = await page.$$eval('#viewer option:disabled', (all) => all.map((option) => option.textContent));
    check_equal(
      'lost: it can not be chosen, and the menu says why',
      disabled,
      Array(2).fill('[2] dot-rule (not shown: could not be planned for this file)'),
    );
  });
});

await on_page('looks', made.html, async (page) => {
  await check_colours(page, folder);
  await check_widths(page, folder);
  await check_paper(page);
});
await group('without scripts', () => check_without_script(browser, made.html));
await group('without WebGL', () => check_without_gl(made.html));

await group('thousands of files', async () => {
  const strips = path.join(folder, 'strips');
  const count = 5000;
  write_strips(strips, count);
  const { html, comparison } = program.compare('strips', [strips], ['tipsify', 'weld, forsyth'], {
    more: ['--with', 'vertex-cache, scene-cost'],
  });
  const size = statSync(html).size;
  check(`thousands of files: the page has ${(size / 1e6).toFixed(1)} MB, of 8 at most`, size <= 8e6, size);
  await on_page('thousands of files', html, (page) => check_files(page, comparison));
});

await browser.close();
process.exit(exit_code());
