// Outlines of cross-sections in their y, z axes, and how their ends are filled.

const kRound = 20;  // corners of a circle

/**
 * {loops: [{points: [[y, z]], smooth, inner}], caps: [[a, b, c]]}: triangles of an end by numbers of
 * the points of all loops, one loop after the other.
 */
export function outline(shape, d, fallback) {
  switch (shape) {
    case 'circle': return solid([ring(d[0] / 2)], kRound);
    case 'tube': return hollow(ring(d[0] / 2), ring(d[0] / 2 - d[1], true), kRound);
    case 'rectangle': return solid([box(d[0], d[1])], 4);
    case 'box': return hollow(box(d[0], d[1]), box(d[0] - 2 * d[2], d[1] - 2 * d[2], true), 4);
    case 'I': return iSection(d);
    default: return solid([ring(fallback)], kRound);
  }
}

function ring(radius, inner = false) {
  const points = [];
  for (let i = 0; i < kRound; ++i) {
    const a = (2 * Math.PI * i) / kRound;
    points.push([radius * Math.cos(a), radius * Math.sin(a)]);
  }
  return { points, smooth: true, inner };
}

function box(width, height, inner = false) {
  const y = width / 2, z = height / 2;
  return { points: [[-y, -z], [y, -z], [y, z], [-y, z]], smooth: false, inner };
}

function solid(loops, n) {
  const caps = [];
  for (let i = 2; i < n; ++i) caps.push([0, i - 1, i]);
  return { loops, caps };
}

function hollow(outer, inner, n) {
  const caps = [];
  for (let i = 0; i < n; ++i) {
    const j = (i + 1) % n;
    caps.push([i, j, n + j], [i, n + j, n + i]);
  }
  return { loops: [outer, inner], caps };
}

function iSection([width, height, flange, web]) {
  const y = width / 2, z = height / 2, f = z - flange, w = web / 2;
  const points = [[-y, -z], [y, -z], [y, -f], [w, -f], [w, f], [y, f], [y, z], [-y, z], [-y, f], [-w, f], [-w, -f], [-y, -f]];
  const quad = (a, b, c, e) => [[a, b, c], [a, c, e]];
  return {
    loops: [{ points, smooth: false, inner: false }],
    caps: [...quad(0, 1, 2, 11), ...quad(10, 3, 4, 9), ...quad(8, 5, 6, 7)],
  };
}

/** Largest distance of a point from the axis. */
export function radius(section) {
  return Math.max(...section.loops[0].points.map(([y, z]) => Math.hypot(y, z)));
}
