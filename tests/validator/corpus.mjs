// Every model of a folder goes through the program, and what comes out must be as valid as what went in:
//   node corpus.mjs PROGRAM FOLDER OUTPUT_FOLDER [--up-to=BYTES] [--shown=WORD,...] OPTIONS...
// With --up-to, models whose files are larger are left out. With --shown, each word must stand in what was written of some
// model: so a test tells when nothing of its kind was shown to the validator.
// Exit 1 where the program failed, or wrote a file with an error that its input did not have, or a word was not shown.

import { spawnSync } from 'node:child_process';
import { mkdirSync, readdirSync, readFileSync, statSync } from 'node:fs';
import path from 'node:path';
import { new_errors, validate } from './validate.mjs';

function models_below(folder) {
  return readdirSync(folder, { withFileTypes: true })
    .sort((a, b) => (a.name < b.name ? -1 : 1))
    .flatMap((entry) => {
      const place = path.join(folder, entry.name);
      if (entry.isDirectory()) return models_below(place);
      return /\.(glb|gltf)$/.test(entry.name) ? [place] : [];
    });
}

const [program, folder, output_folder, ...options] = process.argv.slice(2);
/// What stands behind `--name=` where it is the next option, which is taken away.
function taken(name) {
  return options[0]?.startsWith(`--${name}=`) ? options.shift().slice(name.length + 3) : undefined;
}
const limit = taken('up-to');
const unseen = new Set(taken('shown')?.split(',') ?? []);
const models = models_below(folder).filter((model) => limit === undefined || statSync(model).size <= Number(limit));
let failures = 0;
for (const model of models) {
  const name = path.relative(folder, model);
  const output = path.join(output_folder, name);
  mkdirSync(path.dirname(output), { recursive: true });

  const run = spawnSync(program, ['optimize', model, '-o', output, ...options], { encoding: 'utf8' });
  const faults =
    run.status === 0
      ? new_errors(await validate(model), await validate(output))
      : [`the program ended with ${run.status ?? run.signal ?? run.error?.message}\n${run.stderr ?? ''}`];
  if (faults.length > 0) ++failures;
  if (run.status === 0 && unseen.size > 0) {
    const written = readFileSync(output);
    for (const word of [...unseen].filter((word) => written.includes(`"${word}"`))) unseen.delete(word);
  }
  console.log(faults.length === 0 ? `ok    ${name}` : `FAIL  ${name}: ${faults.join(', ')}`);
}
if (unseen.size > 0) console.log(`FAIL  in no file: ${[...unseen].join(', ')}`);
console.log(`${models.length} models, ${failures} failed`);
process.exit(models.length > 0 && failures === 0 && unseen.size === 0 ? 0 : 1);
