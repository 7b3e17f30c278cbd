// One branch at a time stands out: its columns, its entries in lists, its point in the plot.

const listeners = [];
let pinned = null; // {file, branch} that stays, by a click; branches are numbered by file
let shown = null;

// One rule in place of a class on each of what may be thousands of cells.
const sheet = new CSSStyleSheet();
document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];

const same = (a, b) => a?.file === b?.file && a?.branch === b?.branch;

function show(what) {
  if (same(what, shown)) return;
  shown = what;
  sheet.replaceSync(
    what === null
      ? ''
      : `[data-file="${what.file}"] [data-branch="${what.branch}"] { background-color: var(--highlight); }`,
  );
  for (const listener of listeners) listener(what);
}

/** Calls back with {file, branch}, or null when nothing stands out any more. */
export function on_highlight(listener) {
  listeners.push(listener);
}

/** @param {{file: string, branch: number}|null} what  null: back to what was pinned */
export function highlight(what) {
  show(what ?? pinned);
}

export function pin(what) {
  pinned = same(what, pinned) ? null : what;
  show(pinned);
}

function branch_at(target) {
  const place = target.closest?.('th[data-branch], li[data-branch], button[data-branch]');
  const file = place?.closest('[data-file]');
  return file ? { file: file.dataset.file, branch: Number(place.dataset.branch) } : null;
}

export function start_highlight() {
  document.addEventListener('pointerover', (event) => highlight(branch_at(event.target)));
  document.addEventListener('focusin', (event) => highlight(branch_at(event.target)));
  document.addEventListener('click', (event) => {
    const what = branch_at(event.target);
    if (what !== null) pin(what);
  });
}
