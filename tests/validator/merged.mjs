// Merged draws are valid glTF: node merged.mjs OUTPUT_FOLDER FOREDRAW PROGRAM ARGUMENTS... makes a scene with the program and
// merges it. Exit 1 where something failed, merged nothing, or wrote a file with an error or a warning that the scene did not
// have. The validator does not know the extension and tells of the accessors that only this one names (infos: unused objects).

import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { validate } from './validate.mjs';

const [folder, foredraw, program, ...words] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const scene = path.join(folder, 'scene.glb');
const pipeline = path.join(folder, 'pipeline.toml');
writeFileSync(pipeline, 'pipeline = 1\n[[stages]]\nuse = "merge-instances"\nfrequencies = 3\nmaterials = "kind"\n');

function call(command, args) {
  const run = spawnSync(command, args, { encoding: 'utf8' });
  if (run.status === 0) return;
  console.log(`FAIL  ${command} ${args.join(' ')}: ${run.stderr}`);
  process.exit(1);
}

call(program, [`--output=${scene}`, ...words]);
const before = await validate(scene);
let failures = 0;
for (const name of ['merged.glb', 'merged.gltf']) {
  const output = path.join(folder, name);
  call(foredraw, ['optimize', scene, '--pipeline', pipeline, '-o', output]);
  const after = await validate(output);
  const faults = ['errors', 'warnings'].flatMap((severity) =>
    Object.entries(after[severity])
      .filter(([code, count]) => count > (before[severity][code] ?? 0))
      .map(([code, count]) => `${code} (${count}, was ${before[severity][code] ?? 0})`));
  if (!readFileSync(output).includes('FOREDRAW_merge_instances')) faults.push('nothing is merged');
  if (faults.length > 0) ++failures;
  console.log(faults.length === 0 ? `ok    ${output}` : `FAIL  ${output}: ${faults.join(', ')}`);
  console.log(`      ${JSON.stringify({ infos: after.infos, hints: after.hints })}`);
}
process.exit(failures === 0 ? 0 : 1);
