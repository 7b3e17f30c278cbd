// Light, dark, or as the system has it.

import { element } from './elements.js';

const themes = ['auto', 'light', 'dark'];
const stored_as = 'foredraw-theme';

// Pages of file:// may be denied any storage; the choice is then one for as long as the page is open.
function stored_theme() {
  try {
    return themes.find((theme) => theme === localStorage.getItem(stored_as)) ?? 'auto';
  } catch {
    return 'auto';
  }
}

function store(theme) {
  try {
    localStorage.setItem(stored_as, theme);
  } catch {
    // nothing is lost
  }
}

/** Whether the page is dark, by the button or by the system. */
export const is_dark_now = () =>
  matchMedia('(prefers-color-scheme: dark)').matches
    ? document.documentElement.dataset.theme !== 'light'
    : document.documentElement.dataset.theme === 'dark';

/** Puts the button into the page's head. `on_change` is called whenever colours have changed. */
export function start_theme(on_change) {
  let theme = stored_theme();
  const button = element('button', { type: 'button', class: 'theme', onclick: () => choose(next(theme)) });
  const next = (current) => themes[(themes.indexOf(current) + 1) % themes.length];

  function choose(chosen) {
    theme = chosen;
    if (theme === 'auto') delete document.documentElement.dataset.theme;
    else document.documentElement.dataset.theme = theme;
    button.textContent = { auto: '◐ Auto', light: '○ Light', dark: '● Dark' }[theme];
    button.setAttribute('aria-label', `Colours: ${theme}. Change to ${next(theme)}`);
    store(theme);
    on_change();
  }

  choose(theme);
  document.querySelector('body > header > h1')?.after(button);
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', on_change);
}
