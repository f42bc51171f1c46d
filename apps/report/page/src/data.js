// What the page holds: JSON, and arrays of numbers in one block.

let bytes = null;

/** The data of the page; called once. */
export function load() {
  const data = JSON.parse(document.getElementById('data').textContent);
  const text = atob(document.getElementById('blob').textContent);
  bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return data;
}

/** An array as described by {at, n, type, scale}, as 32-bit floats; indices as integers. */
export function array(d) {
  if (d.type === 'u32') return new Uint32Array(bytes.buffer, d.at, d.n);
  if (d.type === 'f32') return new Float32Array(bytes.buffer, d.at, d.n);
  const raw = new Int16Array(bytes.buffer, d.at, d.n), out = new Float32Array(d.n);
  for (let i = 0; i < d.n; ++i) out[i] = raw[i] * d.scale;
  return out;
}

/** Components [n] of a block, each an array or one number for all. */
export function components(list, n) {
  return list.map((d) => (typeof d === 'number' ? new Float32Array(n).fill(d) : array(d)));
}

/** Value of a line (x growing) at a place, linear between its points. */
export function valueAt(x, y, at) {
  const n = x.length;
  if (n === 0 || at < x[0] || at > x[n - 1]) return n && Math.abs(at - x[n - 1]) < 1e-6 * Math.abs(at) ? y[n - 1] : NaN;
  let low = 0, high = n - 1;
  while (high - low > 1) {
    const mid = (low + high) >> 1;
    if (x[mid] <= at) low = mid;
    else high = mid;
  }
  const span = x[high] - x[low];
  return span > 0 ? y[low] + ((at - x[low]) / span) * (y[high] - y[low]) : y[low];
}
