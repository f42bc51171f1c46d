// How far each node of a body or vertex of a meshed part has moved from rest: what modes and statics are coloured by.

import { Quaternion, Vector3 } from 'three';

const kA = new Vector3(), kB = new Vector3(), kQ = new Quaternion();

/** Sizes of the displacements at record i; leaves body and view there unless they are known. */
export function displacements(view, body, i) {
  const known = (view.displacements ??= new Map());
  if (!known.has(i)) {
    if (known.size > 1) known.delete(known.keys().next().value);  // two, to be between them
    known.set(i, view.sizes ? ofVertices(view, body, i) : ofNodes(body, i));
  }
  return known.get(i);
}

/** The same between two records: instant i and the share s of the way to the next one. */
export function displacementsAt(view, body, i, s) {
  const a = displacements(view, body, i);
  if (s === 0 || i + 1 >= body.instants) return a;
  const b = displacements(view, body, i + 1);
  return a.map((size, k) => (1 - s) * size + s * b[k]);
}

function ofNodes(body, i) {
  body.at(i, 0);
  return Float32Array.from({ length: body.nodes }, (_, k) => kA.fromArray(body.x, 3 * k).distanceTo(kB.fromArray(body.x0, 3 * k)));
}

/** x = x_0 + R_0 (X + u) of a vertex X, with the frame of the first interface. */
function ofVertices(view, body, i) {
  const place = (v, x, q, f, out) => out.set(...[0, 1, 2].map((c) => view.x0[c][v] + f * view.u[3 * v + c]))
    .applyQuaternion(kQ.fromArray(q, 0)).add(new Vector3().fromArray(x, 0));
  body.at(i, 0);
  view.at(i, 0);
  view.deform(1);
  return Float32Array.from({ length: view.vertices }, (_, v) => place(v, body.x, body.q, 1, kA).distanceTo(place(v, body.x0, body.q0, 0, kB)));
}
