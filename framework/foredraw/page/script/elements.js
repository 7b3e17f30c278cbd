// Elements made from values. Text goes in as text: nothing that a file says is ever read as markup.

/**
 * element('button', {class: 'quiet', onclick: f}, 'Play') - null and false are left out.
 * @returns {HTMLElement}
 */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else made.setAttribute(name, value === true ? '' : String(value));
  }
  made.append(...children.filter((child) => child !== null && child !== undefined && child !== false));
  return made;
}

export const button = (text, onclick) => element('button', { type: 'button', onclick }, text);

/** A select with its label: choices are {value, text, disabled?, group?}. */
export function labelled_select(label, choices, on_choice) {
  const select = element('select', { onchange: () => on_choice(select.value) });
  fill_select(select, choices);
  const whole = element('label', { class: 'choice' }, element('span', {}, label), select);
  return { whole, select };
}

/** Choices of one group, where they have one, stand together. */
export function fill_select(select, choices) {
  const groups = new Map();
  const options = [];
  for (const { value, text, disabled, group } of choices) {
    const option = element('option', { value, disabled }, text);
    if (group === undefined) {
      options.push(option);
      continue;
    }
    if (!groups.has(group)) {
      groups.set(group, element('optgroup', { label: group }));
      options.push(groups.get(group));
    }
    groups.get(group).append(option);
  }
  select.replaceChildren(...options);
}

/** The colour that a custom property stands for now, as [r, g, b] from 0 to 255. */
export function colour_of(property) {
  const probe = element('span', { style: `color: var(${property}); display: none` });
  document.body.append(probe);
  const text = getComputedStyle(probe).color;
  probe.remove();
  return text
    .match(/[\d.]+/g)
    .slice(0, 3)
    .map(Number);
}

const number = new Intl.NumberFormat('en', { maximumSignificantDigits: 3 });

/** A length in the file's units, in three digits. */
export const length_text = (length) =>
  length === 0 || (length >= 1e-4 && length < 1e6) ? number.format(length) : length.toExponential(2);

export const css_colour = ([r, g, b], alpha = 1) =>
  `rgba(${Math.round(r)}, ${Math.round(g)}, ${Math.round(b)}, ${alpha})`;
