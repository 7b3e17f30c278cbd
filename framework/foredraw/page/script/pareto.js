// Who is beaten by nobody.

/**
 * The points that no other one beats in one figure without being worse in the other; equal ones all.
 * Points are [x, y], the less the better; what is no number is on no front. Same rule as the program's own.
 * @returns {number[]} their numbers, ascending
 */
export function pareto_front(points) {
  const is_finite = ([x, y]) => Number.isFinite(x) && Number.isFinite(y);
  const beats = ([ax, ay], [bx, by]) => ax <= bx && ay <= by && (ax < bx || ay < by);
  const front = [];
  points.forEach((point, i) => {
    if (!is_finite(point)) return;
    if (!points.some((other) => is_finite(other) && beats(other, point))) front.push(i);
  });
  return front;
}
