// Tables that can be sorted by any column, and long ones filtered.

import { element } from './elements.js';

const rows_without_filter = 30;
const by_text = new Intl.Collator('en', { numeric: true, sensitivity: 'base' });

/** What a cell is compared by: a number, a text, or null where it holds no figure. */
function key_of(cell, is_number) {
  if (!is_number) return cell.textContent.trim();
  const value = cell.dataset.value;
  return value === undefined || value === '' || Number.isNaN(Number(value)) ? null : Number(value);
}

/** Rows in the wanted sequence; equal ones as they came, those without a figure last whichever way it goes. */
function sorted(rows, column, is_number, direction) {
  const keyed = rows.map((row, place) => ({ row, place, key: key_of(row.cells[column], is_number) }));
  const compare = is_number ? (a, b) => a - b : by_text.compare;
  keyed.sort((a, b) => {
    if (a.key === null || b.key === null) return (a.key === null) - (b.key === null) || a.place - b.place;
    return direction * compare(a.key, b.key) || a.place - b.place;
  });
  return keyed.map(({ row }) => row);
}

function make_sortable(table) {
  const body = table.tBodies[0];
  const heads = [...table.tHead.rows[0].cells];
  const rows = [...body.rows]; // as they came
  let sorted_by = null;

  function sort_by(head, column) {
    const was = sorted_by === head ? head.getAttribute('aria-sort') : null;
    const now = was === null ? 'ascending' : was === 'ascending' ? 'descending' : null;
    sorted_by?.removeAttribute('aria-sort');
    sorted_by = now === null ? null : head;
    if (now !== null) head.setAttribute('aria-sort', now);
    const is_number = head.classList.contains('number') || rows.some((row) => row.cells[column].dataset.value);
    body.append(...(now === null ? rows : sorted(rows, column, is_number, now === 'ascending' ? 1 : -1)));
  }

  heads.forEach((head, column) => {
    const button = element('button', { type: 'button', class: 'sort', onclick: () => sort_by(head, column) });
    button.append(...head.childNodes);
    head.append(button);
  });
}

function add_filter(table) {
  const rows = [...table.tBodies[0].rows];
  let texts = null; // made on the first letter
  const count = element('output', { class: 'count' }, `${rows.length} rows`);
  const box = element('input', {
    type: 'search',
    placeholder: 'Filter rows',
    'aria-label': 'Filter rows',
    spellcheck: 'false',
    oninput: filter,
  });

  function filter() {
    texts ??= rows.map((row) => row.textContent.toLowerCase());
    const wanted = box.value.trim().toLowerCase().split(/\s+/);
    let shown = 0;
    rows.forEach((row, i) => {
      row.hidden = !wanted.every((word) => texts[i].includes(word));
      shown += row.hidden ? 0 : 1;
    });
    count.textContent = shown === rows.length ? `${shown} rows` : `${shown} of ${rows.length} rows`;
  }

  (table.closest('.scroll') ?? table).before(element('div', { class: 'filter' }, box, count));
}

export function start_tables() {
  for (const table of document.querySelectorAll('table.sortable')) {
    if (!table.tHead || table.tBodies.length === 0) continue;
    make_sortable(table);
    if (table.tBodies[0].rows.length > rows_without_filter) add_filter(table);
  }
  // What scrolls must be reachable by keyboard.
  for (const scroll of document.querySelectorAll('.scroll')) {
    scroll.tabIndex = 0;
    scroll.setAttribute('role', 'region');
    const title = scroll.closest('section')?.querySelector('h2')?.textContent;
    scroll.setAttribute('aria-label', title ?? 'Table');
  }
}
