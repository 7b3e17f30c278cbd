// From where the most is shaded in vain.

const golden_angle = Math.PI * (3 - Math.sqrt(5));

/** A spiral from +Y to -Y, each direction in a slice of equal area: the views that overdraw is measured from. */
export function fibonacci_directions(count) {
  return Array.from({ length: count }, (_, i) => {
    const y = 1 - (2 * i + 1) / count;
    const ring = Math.sqrt(1 - y * y);
    return [ring * Math.cos(i * golden_angle), y, ring * Math.sin(i * golden_angle)];
  });
}

/** Fragments that passed, pixels that show something, and how many of the first for one of the second. */
export function overdraw_of(counts) {
  let shaded = 0;
  let visible = 0;
  for (const count of counts) {
    shaded += count;
    visible += count > 0 ? 1 : 0;
  }
  return { shaded, visible, ratio: visible === 0 ? null : shaded / visible };
}

/**
 * @param {(directions: number[][]) => Promise<Uint8Array[]>} counted  pictures from several directions
 * @returns {Promise<{direction: number[], ratio: number}|null>} the worst of 100, null where nothing is to be seen
 */
export async function worst_view(counted) {
  const together = 10; // in between the page stays alive
  const directions = fibonacci_directions(100);
  let worst = null;
  for (let i = 0; i < directions.length; i += together) {
    const some = directions.slice(i, i + together);
    (await counted(some)).forEach((counts, n) => {
      const { ratio } = overdraw_of(counts);
      if (ratio !== null && (worst === null || ratio > worst.ratio)) worst = { direction: some[n], ratio };
    });
  }
  return worst;
}
