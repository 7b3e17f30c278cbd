// Colours: [r, g, b] from 0 to 255.

/** How often a pixel is shaded: once, twice, ... the last from there on. The program's heat maps have the same. */
export const heat = [
  [52, 62, 110],
  [42, 120, 142],
  [53, 183, 121],
  [190, 210, 60],
  [253, 180, 47],
  [236, 100, 60],
  [200, 40, 90],
  [255, 225, 255],
];

/** Where nothing is drawn in a heat map. */
export const heat_background = [18, 18, 22];

const to_byte = (linear) => {
  const x = Math.min(1, Math.max(0, linear));
  return 255 * (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);
};

/** From OKLCH (Ottosson 2020), in which equal steps look equally far apart: lightness 0 to 1, chroma, hue in degrees. */
export function oklch(lightness, chroma, hue) {
  const a = chroma * Math.cos((hue * Math.PI) / 180);
  const b = chroma * Math.sin((hue * Math.PI) / 180);
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    to_byte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    to_byte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    to_byte(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}

/** From first (0) to last (1): lightness rises evenly, from deep violet by way of blue and green to yellow. */
export const ramp = (t) => oklch(0.3 + 0.6 * t, 0.11 + 0.05 * t, 305 - 200 * t);

/** Neighbours in number are far apart in hue, and the next round has another lightness. */
export const cluster_colour = (i) => oklch([0.72, 0.58, 0.84][i % 3], 0.13, (i * 137.508) % 360);

/** Of branch i in the plot, dark on light or light on dark. */
export const branch_colour = (i, is_dark) => oklch(is_dark ? 0.78 : 0.52, 0.15, (255 + i * 137.508) % 360);
