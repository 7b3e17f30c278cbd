// The scatter plot itself: points with their errors and numbers, and the step line of the Pareto front.

import {
  Chart,
  LineController,
  LineElement,
  LinearScale,
  LogarithmicScale,
  PointElement,
  ScatterController,
  Tooltip,
} from 'chart.js';
import { branch_colour } from './colours.js';
import { colour_of, css_colour } from './elements.js';
import { axis_title, figure_text, state_name } from './figures.js';
import { is_dark_now } from './theme.js';

Chart.register(LineController, LineElement, LinearScale, LogarithmicScale, PointElement, ScatterController, Tooltip);

const points_dataset = 0;

const wrapped = (text, length = 48) => text.match(new RegExp(`.{1,${length}}`, 'gsu')) ?? [text];

/** Errors as thin crosses below the points, numbers beside them. */
const marks = {
  id: 'marks',
  afterDatasetsDraw(chart) {
    if (chart.data.datasets.length === 0) return;
    const {
      ctx,
      scales: { x, y },
    } = chart;
    const { data, colours, ink } = chart.data.datasets[points_dataset];
    ctx.save();
    ctx.lineWidth = 1;
    ctx.font = '12px system-ui, sans-serif';
    ctx.textBaseline = 'middle';
    data.forEach((point, i) => {
      const [px, py] = [x.getPixelForValue(point.x), y.getPixelForValue(point.y)];
      ctx.strokeStyle = colours[i];
      ctx.beginPath();
      if (point.x_error > 0) {
        ctx.moveTo(x.getPixelForValue(point.x - point.x_error), py);
        ctx.lineTo(x.getPixelForValue(point.x + point.x_error), py);
      }
      if (point.y_error > 0) {
        ctx.moveTo(px, y.getPixelForValue(point.y - point.y_error));
        ctx.lineTo(px, y.getPixelForValue(point.y + point.y_error));
      }
      ctx.stroke();
      const text = point.place === 0 ? 'input' : `[${point.place}]`;
      const is_at_the_end = px + 14 + ctx.measureText(text).width > chart.chartArea.right;
      ctx.textAlign = is_at_the_end ? 'right' : 'left';
      ctx.fillStyle = ink;
      ctx.fillText(text, px + (is_at_the_end ? -11 : 11), py - 9);
    });
    ctx.restore();
  },
};

/** Room around the points; no figure of less than 0 where none is. */
function room_around(values) {
  const [least, most] = [Math.min(...values), Math.max(...values)];
  const room = 0.06 * (most - least);
  return { suggestedMin: least >= 0 ? Math.max(0, least - room) : least - room, suggestedMax: most + room };
}

/** Of the line that shows the error. */
const ends_of = ({ values, errors }, place) => [values[place] - errors[place], values[place] + errors[place]];

function scale_of(axis, places, is_log, ink, grid) {
  return {
    type: is_log ? 'logarithmic' : 'linear',
    ...(is_log ? {} : room_around(places.flatMap((place) => ends_of(axis, place)))),
    title: { display: true, text: axis.unit ? `${axis_title(axis)} (${axis.unit})` : axis_title(axis), color: ink },
    ticks: { color: ink, maxRotation: 0, maxTicksLimit: 8 },
    grid: { color: grid },
    border: { color: grid },
  };
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {(place: number|null) => void} on_hover  the point under the pointer
 * @param {(place: number) => void} on_choice      a point was clicked
 */
export function make_chart(canvas, on_hover, on_choice) {
  let shown = null; // what was drawn last
  const place_at = (elements) =>
    elements.length > 0 ? chart.data.datasets[points_dataset].data[elements[0].index].place : null;
  const chart = new Chart(canvas, {
    type: 'scatter',
    data: { datasets: [] },
    plugins: [marks],
    options: {
      animation: false,
      maintainAspectRatio: false,
      layout: { padding: { top: 12, right: 24 } },
      interaction: { mode: 'nearest', intersect: true },
      onHover: (_, elements) => on_hover(place_at(elements)),
      onClick: (_, elements) => {
        if (elements.length > 0) on_choice(place_at(elements));
      },
      plugins: {
        tooltip: {
          displayColors: false,
          padding: 12,
          filter: (item) => item.datasetIndex === points_dataset,
          callbacks: {
            title: (items) => items.flatMap(({ raw }) => wrapped(state_name(shown.file, raw.place))),
            label: ({ raw }) =>
              [shown.x, shown.y].map((axis) => `${axis_title(axis)}: ${figure_text(axis, raw.place)}`),
          },
        },
      },
    },
  });

  /** Draws points of places of the two axes, those of `front` filled and joined. */
  function draw(what) {
    shown = what;
    const { x, y, places, front, is_log, highlighted } = what;
    const is_dark = is_dark_now();
    const ink = css_colour(colour_of('--ink-soft'));
    const grid = css_colour(colour_of('--line'));
    const paper = css_colour(colour_of('--paper'));
    const colours = places.map((place) => (place === 0 ? ink : css_colour(branch_colour(place - 1, is_dark))));
    const point_at = (place) => ({
      x: x.values[place],
      y: y.values[place],
      x_error: x.errors[place],
      y_error: y.errors[place],
      place,
    });
    const sizes = places.map((place) => (place === highlighted ? 10 : front.includes(place) ? 7 : 5.5));
    const fills = places.map((place, i) => (front.includes(place) ? colours[i] : paper));
    // From one point of the front to the next by way of the corner that both of them beat.
    const best_first = [...front].sort((a, b) => (x.less_is_better ? 1 : -1) * (x.values[a] - x.values[b]));
    chart.data.datasets = [
      {
        data: places.map(point_at),
        colours,
        ink,
        pointRadius: sizes,
        pointHoverRadius: 10,
        pointHitRadius: 6,
        pointBackgroundColor: fills,
        pointHoverBackgroundColor: fills,
        pointBorderColor: colours,
        pointHoverBorderColor: colours,
        pointBorderWidth: 2,
        pointHoverBorderWidth: 2,
      },
      {
        type: 'line',
        data: best_first.map(point_at),
        stepped: 'before',
        pointRadius: 0,
        pointHoverRadius: 0,
        pointHitRadius: 0,
        borderColor: css_colour(colour_of('--accent')),
        borderWidth: 1.5,
        borderDash: [5, 4],
      },
    ];
    chart.options.scales = { x: scale_of(x, places, is_log, ink, grid), y: scale_of(y, places, false, ink, grid) };
    const { tooltip } = chart.options.plugins;
    [tooltip.backgroundColor, tooltip.titleColor, tooltip.bodyColor] = [css_colour(colour_of('--ink')), paper, paper];
    chart.update('none');
  }

  /** Shows the tooltip of a place, or none. */
  function point_out(place) {
    const index = chart.data.datasets[points_dataset]?.data.findIndex((point) => point.place === place) ?? -1;
    const active = index < 0 ? [] : [{ datasetIndex: points_dataset, index }];
    chart.tooltip.setActiveElements(active, { x: 0, y: 0 });
    chart.setActiveElements(active);
    chart.update('none');
  }

  /** The lines of the tooltip that is shown now; none where none is. */
  function tooltip() {
    const { opacity, title, body } = chart.tooltip;
    return opacity === 0 || !body ? [] : [...title, ...body.flatMap(({ lines }) => lines)];
  }

  /** [place, x, y] of each point, in pixels of the canvas. */
  function positions() {
    const { data } = chart.data.datasets[points_dataset];
    return data.map((point) => [
      point.place,
      chart.scales.x.getPixelForValue(point.x),
      chart.scales.y.getPixelForValue(point.y),
    ]);
  }

  return { draw, point_out, tooltip, positions };
}
