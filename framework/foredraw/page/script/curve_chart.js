// One chart of curves over frames: lines, a mark across, and where the slider stands.

import { Chart, LineController, LineElement, LinearScale, PointElement, Tooltip } from 'chart.js';
import { branch_colour } from './colours.js';
import { colour_of, css_colour } from './elements.js';
import { is_dark_now } from './theme.js';

Chart.register(LineController, LineElement, LinearScale, PointElement, Tooltip);

const finite_values = (charts) =>
  charts.flatMap(({ lines, mark }) => [...lines.flatMap(({ values }) => values), mark?.value]).filter(Number.isFinite);

/**
 * What charts beside each other have alike, so that they can be compared.
 * @returns {{least, most, text}}  room around all values and marks, and how a value is told: all with as many decimals
 */
export function measure_of(charts) {
  const values = finite_values(charts);
  const [least, most] = values.reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity]);
  const largest = Math.max(Math.abs(least), Math.abs(most));
  const is_count = values.every(Number.isInteger);
  const decimals = is_count || largest === 0 ? 0 : Math.min(12, Math.max(0, 3 - Math.floor(Math.log10(largest))));
  const number = new Intl.NumberFormat('en', { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
  const { unit } = charts[0];
  const text = (value) => (Number.isFinite(value) ? `${number.format(value)} ${unit}`.trimEnd() : '-');
  if (values.length === 0) return { least: 0, most: 1, text };
  const room = 0.06 * (most - least) || 0.06 * largest || 1;
  return { least: least >= 0 ? Math.max(0, least - room) : least - room, most: most + room, text };
}

/** With its name, which stands above it where there is room. */
function draw_mark({ ctx, chartArea, scales, curves, look }) {
  if (!curves.mark) return;
  const y = Math.round(scales.y.getPixelForValue(curves.mark.value));
  ctx.strokeStyle = look.ink;
  ctx.lineWidth = 2;
  ctx.setLineDash([6, 4]);
  ctx.beginPath();
  ctx.moveTo(chartArea.left, y);
  ctx.lineTo(chartArea.right, y);
  ctx.stroke();
  ctx.setLineDash([]);
  ctx.fillStyle = look.ink;
  ctx.font = '12px system-ui, sans-serif';
  ctx.textAlign = 'right';
  const has_room = y - chartArea.top > 18;
  ctx.textBaseline = has_room ? 'bottom' : 'top';
  const place = [curves.mark.name, chartArea.right - 4, has_room ? y - 4 : y + 4];
  ctx.strokeStyle = look.paper;
  ctx.lineWidth = 4;
  ctx.lineJoin = 'round';
  ctx.strokeText(...place);
  ctx.fillText(...place);
}

function draw_frame({ ctx, chartArea, scales, curves, colours, frame, look }) {
  const x = scales.x.getPixelForValue(frame + 1);
  const column = Math.floor(x) + 0.5; // of whole pixels, so that it is thin and sharp
  ctx.strokeStyle = look.slider;
  ctx.lineWidth = 1;
  ctx.beginPath();
  ctx.moveTo(column, chartArea.top);
  ctx.lineTo(column, chartArea.bottom);
  ctx.stroke();
  ctx.strokeStyle = look.paper;
  curves.lines.forEach(({ values }, i) => {
    if (!Number.isFinite(values[frame])) return;
    ctx.fillStyle = colours[i];
    ctx.beginPath();
    ctx.arc(x, scales.y.getPixelForValue(values[frame]), 4, 0, 2 * Math.PI);
    ctx.fill();
    ctx.stroke();
  });
}

/** What the library does not draw by itself, above the lines; `shown()` tells the rest. */
const marks = (shown) => ({
  id: 'marks',
  afterDatasetsDraw(chart) {
    const { ctx, chartArea, scales } = chart;
    const what = { ...shown(), ctx, chartArea, scales };
    ctx.save();
    draw_mark(what);
    if (what.curves.lines[0].values.length > 1) draw_frame(what);
    ctx.restore();
  },
});

/** A value without neighbours is no line, but it is seen. */
const radii = (values) =>
  values.map((value, i) =>
    Number.isFinite(value) && !Number.isFinite(values[i - 1]) && !Number.isFinite(values[i + 1]) ? 2.5 : 0,
  );

const with_unit = (name, unit) => (unit === '' ? name : `${name} (${unit})`);

/**
 * @param {HTMLCanvasElement} canvas
 * @param {object} curves  as the page's JSON has them
 * @param {object} measure  measure_of() the charts that this one is compared with
 * @param {number[]} numbers  [line] of its colour
 * @param {(frame: number) => void} on_choice  a frame was clicked, from 0
 */
export function make_curve_chart(canvas, curves, measure, numbers, on_choice) {
  const frames = curves.lines[0].values.length;
  let frame = 0;
  let look = {};
  let colours = [];
  const chart = new Chart(canvas, {
    type: 'line',
    data: {
      datasets: curves.lines.map(({ name, values }) => ({
        label: name,
        data: values.map((y, i) => ({ x: i + 1, y })),
        pointRadius: radii(values),
        pointHoverRadius: 4,
        borderWidth: 2,
        borderJoinStyle: 'round',
      })),
    },
    plugins: [marks(() => ({ curves, colours, frame, look }))],
    options: {
      animation: false,
      maintainAspectRatio: false,
      parsing: false,
      normalized: true,
      scales: { x: { type: 'linear' }, y: { type: 'linear' } },
      layout: { padding: { top: 8, right: 12 } },
      interaction: { mode: 'index', axis: 'x', intersect: false },
      onClick: (event, elements) => {
        if (elements.length > 0) on_choice(elements[0].index);
      },
      plugins: {
        tooltip: {
          padding: 12,
          boxPadding: 4,
          caretPadding: 8,
          callbacks: {
            title: ([item]) => (item ? `${curves.x} ${item.raw.x} of ${frames}` : ''),
            label: ({ dataset, raw }) => `${dataset.label}: ${measure.text(raw.y)}`,
            footer: () => (curves.mark ? `${curves.mark.name}: ${measure.text(curves.mark.value)}` : ''),
          },
        },
      },
    },
  });

  /** With the colours that the page has now. */
  function redraw() {
    const now = (property) => css_colour(colour_of(property));
    look = { ink: now('--ink-soft'), slider: now('--ink'), line: now('--line'), paper: now('--raised') };
    colours = numbers.map((number) => css_colour(branch_colour(number, is_dark_now())));
    chart.data.datasets.forEach((dataset, i) => {
      for (const property of ['borderColor', 'backgroundColor', 'pointBackgroundColor', 'pointBorderColor'])
        dataset[property] = colours[i];
    });
    const axis = (title) => ({
      type: 'linear',
      title: { display: title !== '', text: title, color: look.ink },
      ticks: { color: look.ink, maxRotation: 0, maxTicksLimit: 7 },
      grid: { color: look.line },
      border: { color: look.line },
    });
    const across = axis(curves.x);
    chart.options.scales = {
      x: { ...across, min: 1, max: Math.max(frames, 2), ticks: { ...across.ticks, precision: 0 } },
      y: { ...axis(with_unit(curves.y, curves.unit)), suggestedMin: measure.least, suggestedMax: measure.most },
    };
    const { tooltip } = chart.options.plugins;
    tooltip.backgroundColor = now('--ink');
    for (const part of ['titleColor', 'bodyColor', 'footerColor']) tooltip[part] = look.paper;
    chart.update('none');
  }

  function set_frame(shown) {
    frame = shown;
    chart.draw();
  }

  /** The lines of the tooltip that is shown now; none where none is. */
  function tooltip() {
    const { opacity, title, body, footer } = chart.tooltip;
    return opacity === 0 || !body ? [] : [...title, ...body.flatMap(({ lines }) => lines), ...footer];
  }

  redraw();
  return {
    set_frame,
    redraw,
    tooltip,
    destroy: () => chart.destroy(),
    /** [x, y] of a frame and a value, in pixels of the canvas as the page shows it. */
    position: (at, value) => [chart.scales.x.getPixelForValue(at + 1), chart.scales.y.getPixelForValue(value)],
  };
}
