// A slider with a play button before and a text behind it.

import { button, element } from './elements.js';

/**
 * @param {string} label          of the slider
 * @param {string} player_label   what the button plays
 * @returns {{whole, play, update}}  `update` shows a value, the greatest one, and both in words
 */
export function slider_row(label, player_label, on_input, on_play) {
  const play = button('Play', on_play);
  const slider = element('input', {
    type: 'range',
    min: 0,
    'aria-label': label,
    oninput: () => on_input(Number(slider.value)),
  });
  const text = element('output', {});
  const whole = element('div', { class: 'slider' }, play, slider, text);
  function update(is_playing, value, most, words, step = 1) {
    play.textContent = is_playing ? 'Pause' : 'Play';
    play.setAttribute('aria-label', `${is_playing ? 'Pause' : 'Play'}: ${player_label}`);
    slider.max = String(most);
    slider.step = String(step);
    slider.value = String(value);
    slider.setAttribute('aria-valuetext', words);
    text.textContent = words;
  }
  return { whole, play, update };
}
