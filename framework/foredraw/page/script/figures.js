// The figures of one compared file, as the plot wants them: values, errors and units by branch.

// More dotted metrics of one family, such as ratios of 64 poses, are nothing to choose from in a list.
const largest_family = 16;

/** A metric with dots lies in nested objects: its first word, all between, its last word. */
function nested(metrics, evaluator, metric) {
  const first = metric.indexOf('.');
  const last = metric.lastIndexOf('.');
  const of_evaluator = metrics?.[evaluator];
  if (first < 0) return of_evaluator?.[metric];
  const family = of_evaluator?.[metric.slice(0, first)];
  if (first === last) return family?.[metric.slice(first + 1)];
  return family?.[metric.slice(first + 1, last)]?.[metric.slice(last + 1)];
}

const family_of = (row) => `${row.evaluator} ${row.metric.split('.')[0]}`;

function can_be_chosen(row, family_sizes) {
  const has_values = [row.input, ...(row.values ?? [])].some(Number.isFinite);
  return has_values && (!row.metric.includes('.') || family_sizes.get(family_of(row)) <= largest_family);
}

/**
 * One axis that the plot can have.
 * @typedef {object} Axis
 * @property {string} key
 * @property {string} name
 * @property {string} group      the evaluator
 * @property {string} unit
 * @property {boolean} is_count  told without decimals
 * @property {boolean} less_is_better  unless the comparison's row says "lower-is-better": false
 * @property {(number|null)[]} values  [0] the input, [i + 1] branch i
 * @property {number[]} errors         alike; 0: exact or unknown
 */

/** @returns {Axis[]} time first */
export function axes_of(file) {
  const family_sizes = new Map();
  for (const row of file.metrics) family_sizes.set(family_of(row), (family_sizes.get(family_of(row)) ?? 0) + 1);
  const time = {
    key: 'time',
    name: 'time of all stages',
    group: 'the run',
    unit: 'ms',
    is_count: false,
    less_is_better: true,
    values: [null, ...file.branches.map((branch) => (Number.isFinite(branch.seconds) ? 1000 * branch.seconds : null))],
    errors: [0, ...file.branches.map(() => 0)],
  };
  return [time, ...file.metrics.filter((row) => can_be_chosen(row, family_sizes)).map((row) => axis_of(file, row))];
}

function axis_of(file, row) {
  const totals = file.branches.map((branch) => branch.report?.totals);
  const details = [totals.find((total) => total?.before)?.before, ...totals].map((total) =>
    nested(total?.metrics, row.evaluator, row.metric),
  );
  const known = details.find((detail) => detail);
  return {
    key: `${row.evaluator} ${row.metric}`,
    name: row.metric,
    group: row.evaluator,
    unit: known?.unit ?? '',
    is_count: known !== undefined && known.denominator === undefined,
    less_is_better: row['lower-is-better'] !== false,
    values: [row.input ?? null, ...file.branches.map((_, i) => row.values?.[i] ?? null)],
    errors: details.map((detail) => detail?.error ?? 0),
  };
}

/** "overdraw-raster ratio", or "time" */
export const axis_title = (axis) => (axis.key === 'time' ? 'time' : `${axis.group} ${axis.name}`);

/** "1.0484 ±0.0045 fragments per pixel" */
export function figure_text(axis, place) {
  const value = axis.values[place];
  if (!Number.isFinite(value)) return '-';
  const digits = axis.is_count ? 0 : axis.key === 'time' ? 1 : 4;
  const error = axis.errors[place] > 0 ? ` ±${axis.errors[place].toFixed(digits)}` : '';
  return `${value.toFixed(digits)}${error} ${axis.unit}`.trim();
}

/** What a state is called: [0] the input, [i + 1] branch i. */
export function state_name(file, place) {
  return place === 0 ? 'input' : `[${place}] ${file.branches[place - 1].name}`;
}

/** Paths without the folders that all of them begin with. */
export function short_paths(files) {
  const split = files.map((file) => file.input.path.split('/'));
  let common = 0;
  while (split.every((parts) => common < parts.length - 1 && parts[common] === split[0][common])) ++common;
  return split.map((parts) => parts.slice(common).join('/'));
}

/** What most people weigh against each other, or the first two. */
export function default_axes(axes) {
  const overdraw = axes.find((axis) => axis.key === 'overdraw-raster ratio');
  return overdraw ? ['time', overdraw.key] : [axes[0].key, (axes[1] ?? axes[0]).key];
}
