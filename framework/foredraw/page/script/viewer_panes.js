// One or two panes side by side over one canvas, with what is told of each below it.

import { element } from './elements.js';

const help = 'Arrow keys turn, plus and minus zoom, Home resets.';

function make_pane() {
  const window = element('div', { class: 'window', tabindex: 0, role: 'img' });
  const name = element('strong', {});
  const ratio = element('span', { class: 'ratio' });
  const order = element('span', { class: 'order' });
  const figure = element('figure', { class: 'pane' }, window, element('figcaption', {}, name, ratio, order));
  return { figure, window, name, ratio, order };
}

export class Panes {
  constructor(canvas) {
    this.canvas = canvas;
    this.panes = [make_pane(), make_pane()];
    this.whole = element('div', { class: 'panes' }, canvas, ...this.panes.map(({ figure }) => figure));
  }

  get windows() {
    return this.panes.map(({ window }) => window);
  }

  /** Of the canvas's pixels to CSS pixels. */
  get ratio() {
    return Math.min(devicePixelRatio, 2);
  }

  show(are_shown) {
    this.panes.forEach(({ figure }, i) => {
      figure.hidden = !are_shown[i];
    });
  }

  /** The canvas lies below all of it, so that the style sheet alone decides where panes are. */
  fit(set_size) {
    const { clientWidth, clientHeight } = this.whole;
    const { ratio } = this;
    const wanted = `${clientWidth} ${clientHeight} ${ratio}`;
    if (wanted === this.fitted) return;
    this.fitted = wanted;
    set_size(clientWidth, clientHeight, ratio);
  }

  /** The pane's rectangle in CSS pixels from the canvas's lower left corner. */
  place(pane) {
    const outer = this.whole.getBoundingClientRect();
    const inner = this.panes[pane].window.getBoundingClientRect();
    return { x: inner.left - outer.left, y: outer.bottom - inner.bottom, width: inner.width, height: inner.height };
  }

  tell(pane, name, remark) {
    const texts = this.panes[pane];
    texts.name.textContent = name;
    texts.order.textContent = remark;
    texts.ratio.classList.add('stale');
    texts.window.setAttribute('aria-label', `${name}, drawn. ${help}`);
  }

  tell_ratio(pane, ratio) {
    const text = this.panes[pane].ratio;
    text.classList.remove('stale');
    text.textContent = ratio === null ? 'nothing is drawn' : `${ratio.toFixed(3)} fragments per pixel`;
    text.title = 'Of this view as overdraw-raster counts it: orthographic, the whole subject in 256 pixels';
  }
}
