// Asks the Khronos glTF validator about files: node validate.mjs FILE... prints one JSON array, a record for each file:
//   {"file": "...", "errors": {"CODE": count, ...}, "warnings": {...}, "infos": {...}, "hints": {...}}
// Files that a model refers to are looked for beside it. A file that is no glTF at all has the error UNREADABLE.

import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import validator from 'gltf-validator';

const severities = ['errors', 'warnings', 'infos', 'hints'];

export async function validate(file) {
  const record = { file, errors: {}, warnings: {}, infos: {}, hints: {} };
  const options = {
    uri: path.basename(file),
    maxIssues: 0,  // all of them
    externalResourceFunction: async (uri) =>
      new Uint8Array(await readFile(path.resolve(path.dirname(file), decodeURIComponent(uri)))),
  };
  try {
    const { issues } = await validator.validateBytes(new Uint8Array(await readFile(file)), options);
    for (const { severity, code } of issues.messages) {
      const counts = record[severities[severity]];
      counts[code] = (counts[code] ?? 0) + 1;
    }
  } catch (error) {
    record.errors.UNREADABLE = 1;
    record.reason = String(error?.message ?? error);
  }
  return record;
}

/// What `output` is accused of that `input` was not, or not so often: ["CODE (3, was 0)", ...].
export function new_errors(input, output) {
  return Object.entries(output.errors)
    .filter(([code, count]) => count > (input.errors[code] ?? 0))
    .map(([code, count]) => `${code} (${count}, was ${input.errors[code] ?? 0})`);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const records = [];
  for (const file of process.argv.slice(2)) records.push(await validate(file));
  console.log(JSON.stringify(records, null, 2));
}
