// What a program makes by itself is valid glTF: node made.mjs OUTPUT PROGRAM ARGUMENTS... calls the program with --output=OUTPUT.
// Exit 1 where the program failed, or wrote a file with an error or a warning.

import { spawnSync } from 'node:child_process';
import { validate } from './validate.mjs';

const [output, program, ...words] = process.argv.slice(2);
const run = spawnSync(program, [...words, `--output=${output}`], { encoding: 'utf8' });
const record = run.status === 0 ? await validate(output) : { errors: { [run.stderr]: 1 }, warnings: {} };
const faults = [...Object.keys(record.errors), ...Object.keys(record.warnings)];
console.log(faults.length === 0 ? `ok    ${output}` : `FAIL  ${output}: ${faults.join(', ')}`);
process.exit(faults.length === 0 ? 0 : 1);
