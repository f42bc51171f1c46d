// How far a mode moves each node of a beam or vertex of a meshed part: what modes are coloured by.

import { Quaternion, Vector3 } from 'three';

const kA = new Vector3(), kB = new Vector3(), kQ = new Quaternion();

/** Sizes of the displacements from rest of the mode i, whatever its phase; leaves body and view at that mode. */
export function modeSizes(view, body, i) {
  const cache = (view.modeSizes ??= new Map());
  if (!cache.has(i)) cache.set(i, view.sizes ? ofVertices(view, body, i) : ofNodes(body, i));
  return cache.get(i);
}

function ofNodes(body, i) {
  body.mode(i, 1);
  return Float32Array.from({ length: body.nodes }, (_, k) => kA.fromArray(body.x, 3 * k).distanceTo(kB.fromArray(body.x0, 3 * k)));
}

/** x = x_0 + R_0 (X + u) of a vertex X, with the frame of the first interface. */
function ofVertices(view, body, i) {
  const place = (v, x, q, f, out) => out.set(...[0, 1, 2].map((c) => view.x0[c][v] + f * view.u[3 * v + c]))
    .applyQuaternion(kQ.fromArray(q, 0)).add(new Vector3().fromArray(x, 0));
  body.mode(i, 1);
  view.mode(i, 1);
  view.deform();
  return Float32Array.from({ length: view.vertices }, (_, v) => place(v, body.x, body.q, 1, kA).distanceTo(place(v, body.x0, body.q0, 0, kB)));
}
