// Named checks: all are made. Told are the groups, how many of their checks hold, and those that fail.

const failed = [];
let made = 0;
let held = 0;

const shown = (value) => (typeof value === 'string' ? value : JSON.stringify(value));

export function check(name, holds, detail = '') {
  ++made;
  if (holds) {
    ++held;
  } else {
    failed.push(name);
    console.log(`FAIL  ${name}${detail === '' ? '' : `: ${shown(detail)}`}`);
  }
}

export function check_equal(name, is, should_be) {
  check(name, JSON.stringify(is) === JSON.stringify(should_be), `${shown(is)}, should be ${shown(should_be)}`);
}

export function check_near(name, is, should_be, tolerance) {
  const off = Math.abs(is - should_be) / Math.abs(should_be);
  check(name, off <= tolerance, `${is}, should be ${should_be}`);
}

/** Those of --only=NAME,..., if there is such an argument: a group outside of them is left out with the groups in it. */
const only = process.argv.find((word) => word.startsWith('--only='))?.slice('--only='.length).split(',');
let depth = 0;

/** A group of checks: what it throws is one more that fails, and the other groups go on. */
export async function group(name, run) {
  if (depth === 0 && only !== undefined && !only.includes(name)) return;
  ++depth;
  const began = performance.now();
  console.log(`-- ${name}`);
  const [made_before, held_before] = [made, held];
  try {
    await run();
  } catch (error) {
    check(`${name} comes to its end`, false, error.stack);
  }
  --depth;
  const seconds = ((performance.now() - began) / 1000).toFixed(1);
  console.log(`      ${held - held_before} of ${made - made_before} hold, ${seconds} s`);
}

export function exit_code() {
  console.log(`${made} checks, ${failed.length} failed${failed.map((name) => `\n  ${name}`).join('')}`);
  return made > 0 && failed.length === 0 ? 0 : 1;
}
