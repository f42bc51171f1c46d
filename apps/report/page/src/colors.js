// Colours of values: viridis for sizes, blue-grey-red for signs.

const kViridis = [
  [0.278, 0.085, 0.410], [0.283, 0.161, 0.468], [0.254, 0.265, 0.530], [0.207, 0.372, 0.553],
  [0.164, 0.471, 0.558], [0.128, 0.567, 0.551], [0.135, 0.659, 0.518], [0.267, 0.749, 0.441],
  [0.478, 0.821, 0.318], [0.741, 0.873, 0.150], [0.993, 0.906, 0.144],
];
const kSigned = [
  [0.10, 0.32, 0.75], [0.36, 0.58, 0.90], [0.72, 0.80, 0.92], [0.80, 0.80, 0.80],
  [0.95, 0.72, 0.62], [0.88, 0.42, 0.30], [0.70, 0.09, 0.15],
];

function table(stops) {
  const out = new Float32Array(3 * 256);
  for (let i = 0; i < 256; ++i) {
    const at = (i / 255) * (stops.length - 1), k = Math.min(Math.floor(at), stops.length - 2);
    for (let c = 0; c < 3; ++c)
      out[3 * i + c] = stops[k][c] + (at - k) * (stops[k + 1][c] - stops[k][c]);
  }
  return out;
}
const kTables = { size: table(kViridis), signed: table(kSigned) };

/** Writes the colour of a share 0 .. 1 into out at `at`. */
export function paint(map, share, out, at) {
  const t = kTables[map], i = 3 * Math.max(0, Math.min(255, Math.round(255 * share)));
  out[at] = t[i];
  out[at + 1] = t[i + 1];
  out[at + 2] = t[i + 2];
}

/** CSS colour of a share 0 .. 1. */
export function css(map, share) {
  const t = kTables[map], i = 3 * Math.max(0, Math.min(255, Math.round(255 * share)));
  return `rgb(${[0, 1, 2].map((c) => Math.round(255 * t[i + c])).join(' ')})`;
}

/** Lines and points that have to be told apart; readable on light and dark. */
export const kSeries = ['#2f7fd8', '#e08a1e', '#2a9d63', '#c8453b', '#8b62c9', '#8a6d3b', '#d65fa0', '#6c7a89'];
