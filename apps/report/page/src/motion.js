// The motion at any instant: frames of the nodes between two records, and the chord of each body.

import { Quaternion, Vector3 } from 'three';
import { array, components } from './data.js';

/** A body's nodes at the instant that `at` was called with: x [3 N], q [4 N] (x, y, z, w). */
export class Body {
  constructor(d, instants) {
    const n = instants * d.nodes;
    Object.assign(this, { name: d.name, kind: d.kind, nodes: d.nodes, instants, elements: [] });
    for (let e = 0; e < d.elements.length; e += 2) this.elements.push([d.elements[e], d.elements[e + 1]]);
    this.shapes = d.shapes;
    this.dimensions = d.dimensions;
    this.points = d.points;
    this.xs = components(d.x, n);
    this.qs = components(d.q, n);
    this.x0 = array(d.x0);
    this.q0 = array(d.q0);
    this.force = d.force ? components(d.force, n) : null;
    this.stress = d.stress ? array(d.stress) : null;
    this.x = new Float32Array(3 * d.nodes);
    this.q = new Float32Array(4 * d.nodes);
  }

  /** Between two records: instant i and the share s of the way to the next one. */
  at(i, s) {
    const N = this.nodes, a = i * N, b = Math.min(i + 1, this.instants - 1) * N;
    for (let k = 0; k < N; ++k) {
      for (let c = 0; c < 3; ++c)
        this.x[3 * k + c] = (1 - s) * this.xs[c][a + k] + s * this.xs[c][b + k];
      for (let c = 0; c < 4; ++c)
        this.q[4 * k + c] = (1 - s) * this.qs[c][a + k] + s * this.qs[c][b + k];
      normalise(this.q, 4 * k);
    }
  }

  /** Moves the frames on, to `size` times what they have moved from rest. */
  enlarge(size) {
    const { x, q, x0, q0 } = this;
    if (size === 1) return;
    for (let i = 0; i < x.length; ++i) x[i] = x0[i] + size * (x[i] - x0[i]);
    for (let k = 0; k < q.length; k += 4) {
      let dot = 0;
      for (let c = k; c < k + 4; ++c) dot += q0[c] * q[c];
      for (let c = k; c < k + 4; ++c) q[c] = q0[c] + size * (Math.sign(dot || 1) * q[c] - q0[c]);
      normalise(q, k);
    }
  }

  /** Values [instants, N] of nodes or ends of elements at an instant, into `out` [N]. */
  values(field, i, s, out) {
    const N = out.length, a = i * N, b = Math.min(i + 1, this.instants - 1) * N;
    for (let k = 0; k < N; ++k) out[k] = (1 - s) * field[a + k] + s * field[b + k];
  }
}

function normalise(q, at) {
  const size = Math.hypot(q[at], q[at + 1], q[at + 2], q[at + 3]) || 1;
  for (let c = 0; c < 4; ++c) q[at + c] /= size;
}

const kA = new Quaternion(), kB = new Quaternion();

/**
 * What of a body's shape is deformation, seen from its chord: the straight line between two of its nodes,
 * its outermost joints (without two of them its ends), which stay where they are whatever the scale.
 *   d = x - lerp(x_a, x_b) - Q (X - lerp(X_a, X_b)),  Q: mean turn of the nodes
 * Displayed is x + (scale - 1) d + e; tangents along an element likewise. e closes joints elsewhere (closure.js).
 */
export class Chord {
  constructor(body) {
    this.body = body;
    this.turn = new Quaternion();
    this.d = new Float32Array(3 * body.nodes);
    this.e = new Float32Array(3 * body.nodes);
    this.v = new Vector3();
    this.along = new Float32Array(body.nodes);  // length up to each node
    for (let k = 1; k < body.nodes; ++k) this.along[k] = this.along[k - 1] + distance(body.x0, k - 1, k);
    this.between(0, body.nodes - 1);
  }

  /** Between two other nodes. */
  between(first, last) {
    const { along } = this;
    this.anchors = [first, last];
    this.length = along[last] - along[first];
    this.share = along.map((s) => (s - along[first]) / (this.length || 1));
  }

  update() {
    const { body, anchors, turn, v } = this;
    meanTurn(body, turn);
    for (let k = 0; k < body.nodes; ++k) {
      const s = this.share[k];
      v.set(...[0, 1, 2].map((c) => body.x0[3 * k + c] - mix(body.x0, c, anchors, s))).applyQuaternion(turn);
      this.d[3 * k] = body.x[3 * k] - mix(body.x, 0, anchors, s) - v.x;
      this.d[3 * k + 1] = body.x[3 * k + 1] - mix(body.x, 1, anchors, s) - v.y;
      this.d[3 * k + 2] = body.x[3 * k + 2] - mix(body.x, 2, anchors, s) - v.z;
    }
  }

  /** Sets e: (1 - s) a + s b along the chord, and `by` of each of the bumps {node, by}, falling to nothing at the next one. */
  shift(a, b, bumps) {
    const { anchors, e, share, v } = this;
    const knots = [...new Set([...anchors, ...bumps.map((bump) => bump.node)])].sort((i, j) => i - j);
    for (let k = 0; k < share.length; ++k) {
      v.copy(a).lerp(b, share[k]);
      for (const { node, by } of bumps) v.addScaledVector(by, hat(share, knots, node, k));
      v.toArray(e, 3 * k);
    }
  }

  /** Displayed place of node k. */
  place(k, scale, out) {
    const { d, e } = this, x = this.body.x, f = scale - 1, i = 3 * k;
    return out.set(x[i] + f * d[i] + e[i], x[i + 1] + f * d[i + 1] + e[i + 1], x[i + 2] + f * d[i + 2] + e[i + 2]);
  }

  /** Displayed tangent of the element between nodes i and j, of this length, at its node k, dx/dxi. */
  tangent(i, j, k, length, scale, out) {
    const { body, anchors: [a, b], turn, v, e } = this, f = scale - 1, share = length / (this.length || 1);
    axis(body.q, k, out).multiplyScalar(length);
    axis(body.q0, k, v).multiplyScalar(length);
    v.x -= share * (body.x0[3 * b] - body.x0[3 * a]);
    v.y -= share * (body.x0[3 * b + 1] - body.x0[3 * a + 1]);
    v.z -= share * (body.x0[3 * b + 2] - body.x0[3 * a + 2]);
    v.applyQuaternion(turn);
    return out.set(
      out.x + f * (out.x - share * (body.x[3 * b] - body.x[3 * a]) - v.x) + e[3 * j] - e[3 * i],
      out.y + f * (out.y - share * (body.x[3 * b + 1] - body.x[3 * a + 1]) - v.y) + e[3 * j + 1] - e[3 * i + 1],
      out.z + f * (out.z - share * (body.x[3 * b + 2] - body.x[3 * a + 2]) - v.z) + e[3 * j + 2] - e[3 * i + 2]);
  }

  /** |d| at node k. */
  size(k) {
    return Math.hypot(this.d[3 * k], this.d[3 * k + 1], this.d[3 * k + 2]);
  }
}

/** 1 at node n, linear to 0 at the knots beside it; beyond the last knot 1. */
function hat(share, knots, n, k) {
  const at = knots.indexOf(n), next = k < n ? knots[at - 1] : knots[at + 1];
  return k === n || next === undefined ? 1 : Math.max(0, 1 - (share[k] - share[n]) / (share[next] - share[n]));
}

function mix(x, c, [first, last], s) {
  return (1 - s) * x[3 * first + c] + s * x[3 * last + c];
}
function distance(x, i, j) {
  return Math.hypot(x[3 * j] - x[3 * i], x[3 * j + 1] - x[3 * i + 1], x[3 * j + 2] - x[3 * i + 2]);
}

/** First axis of a node's frame. */
export function axis(q, k, out) {
  const x = q[4 * k], y = q[4 * k + 1], z = q[4 * k + 2], w = q[4 * k + 3];
  return out.set(1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w));
}

/** Mean of the turns q q0^-1 of all nodes. */
function meanTurn(body, out) {
  let sx = 0, sy = 0, sz = 0, sw = 0;
  for (let k = 0; k < body.nodes; ++k) {
    kA.fromArray(body.q, 4 * k);
    kB.fromArray(body.q0, 4 * k).conjugate();
    kA.multiply(kB);
    const sign = sx * kA.x + sy * kA.y + sz * kA.z + sw * kA.w < 0 ? -1 : 1;
    sx += sign * kA.x;
    sy += sign * kA.y;
    sz += sign * kA.z;
    sw += sign * kA.w;
  }
  out.set(sx, sy, sz, sw).normalize();
}
