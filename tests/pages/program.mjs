// What the program makes: pages with their reports, figures of single views, remap tables.

import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';

export class Program {
  constructor(program, folder) {
    Object.assign(this, { program, folder });
    mkdirSync(folder, { recursive: true });
  }

  /** What it prints. */
  run(given, exit_code = 0) {
    const { status, signal, error, stdout, stderr } = spawnSync(this.program, given, {
      encoding: 'utf8',
      maxBuffer: 2 ** 30,
    });
    if (status !== exit_code) throw new Error(`${given.join(' ')} ended with ${status ?? signal ?? error}\n${stderr}`);
    return stdout;
  }

  /** `foredraw compare` of models with pipelines: {html, comparison, scenes}. */
  compare(name, models, pipelines, { more = [], exit_code = 0 } = {}) {
    const html = path.join(this.folder, `${name}.html`);
    const report = path.join(this.folder, `${name}.json`);
    const from = [...models, ...pipelines.flatMap((pipeline) => ['-p', pipeline]), ...more];
    this.run(['compare', ...from, '--html', html, '--report', report], exit_code);
    const scenes = readFileSync(html, 'utf8').match(/<script type="application\/json" id="scenes">([^]*?)<\/script>/);
    return {
      html,
      comparison: JSON.parse(readFileSync(report, 'utf8')),
      scenes: scenes ? JSON.parse(scenes[1]).scenes : null,
    };
  }

  /** What overdraw-raster says of one orthographic view of the model as it is. */
  overdraw(model, direction, options = '') {
    const views = path.join(this.folder, 'one.views');
    writeFileSync(views, `direction ${direction.join(' ')}\n`);
    const evaluator = `overdraw-raster(views="${views}"${options})`;
    return JSON.parse(this.run(['measure', model, '--with', evaluator, '--json'])).totals.metrics['overdraw-raster'];
  }

  /** The file that a pipeline makes of a model. */
  optimized(model, pipeline) {
    const output = path.join(this.folder, `optimized-${path.basename(model)}`);
    this.run(['optimize', model, '-p', pipeline, '-o', output]);
    return output;
  }

  /** [draw][new place] -> number of the triangle in the file, or null where nothing moved. */
  remap(model, pipeline) {
    const table = path.join(this.folder, 'remap.json');
    const output = path.join(this.folder, 'remapped.glb');
    this.run(['optimize', model, '-p', pipeline, '-o', output, '-o', `remap:${table}`]);
    return JSON.parse(readFileSync(table, 'utf8')).draws.map(({ triangles }) => triangles?.['new-to-old'] ?? null);
  }
}
