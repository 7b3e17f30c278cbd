// What is written of an image, and of a frame list of it, is valid glTF: node sprites.mjs PROGRAM IMAGE OUTPUT_FOLDER
// Exit 1 where the program failed, or wrote a file with an error or a warning.

import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { validate } from './validate.mjs';

const [program, image, folder] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
copyFileSync(image, path.join(folder, 'atlas.png'));
const frame = (x, rotated) => ({ frame: { x, y: 0, w: 16, h: 12 }, rotated });
const list = { frames: { plain: frame(0, false), turned: frame(32, true) }, meta: { image: 'atlas.png' } };
writeFileSync(path.join(folder, 'list.json'), JSON.stringify(list));

let failures = 0;
for (const input of ['atlas.png', 'list.json']) {
  for (const kind of ['.glb', '.gltf']) {
    const output = path.join(folder, input + kind);
    const run = spawnSync(program, ['optimize', path.join(folder, input), '-p', '', '-o', output], { encoding: 'utf8' });
    const record = run.status === 0 ? await validate(output) : { errors: { [run.stderr]: 1 }, warnings: {} };
    const faults = [...Object.keys(record.errors), ...Object.keys(record.warnings)];
    if (faults.length > 0) ++failures;
    console.log(faults.length === 0 ? `ok    ${output}` : `FAIL  ${output}: ${faults.join(', ')}`);
  }
}
process.exit(failures === 0 ? 0 : 1);
