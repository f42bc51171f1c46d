// What bodies can be coloured by, with the range over the whole motion.

const kForces = [
  ['N', 'axial force', 'N', [0], 'signed'],
  ['V', 'shear force', 'N', [1, 2], 'size'],
  ['M', 'bending moment', 'N m', [4, 5], 'size'],
  ['T', 'torque', 'N m', [3], 'signed'],
];

/**
 * [{key, label, unit, map, field(body) -> [instants, N] or null}], only those that vary.
 * @param inSolids largest stress in meshed parts
 */
export function quantities(bodies, inSolids) {
  const stress = entry('stress', 'stress (von Mises)', 'Pa', 'size', (b) => b.stress, bodies);
  stress.high = stress.size = Math.max(stress.size, inSolids);
  const list = [stress];
  for (const [key, label, unit, which, map] of kForces)
    list.push(entry(key, label, unit, map, (b) => (b.force ? combined(b, which) : null), bodies));
  return list.filter((q) => q.high > q.low && q.size > 1e-9);
}

function entry(key, label, unit, map, field, bodies) {
  const fields = new Map(bodies.map((b) => [b.name, field(b)]));
  let size = 0;
  for (const values of fields.values()) for (const x of values ?? []) size = Math.max(size, Math.abs(x));
  return { key, label, unit, map, size, low: map === 'signed' ? -size : 0, high: size, field: (b) => fields.get(b.name) };
}

function combined(body, which) {
  if (which.length === 1) return body.force[which[0]];
  const [a, b] = which.map((c) => body.force[c]), out = new Float32Array(a.length);
  for (let i = 0; i < a.length; ++i) out[i] = Math.hypot(a[i], b[i]);
  return out;
}
