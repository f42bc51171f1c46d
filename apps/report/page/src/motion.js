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

  /** A shape of vibration: the frames at rest moved by `size` of mode i. */
  mode(i, size) {
    const N = this.nodes, a = i * N;
    for (let k = 0; k < N; ++k) {
      for (let c = 0; c < 3; ++c) {
        const rest = this.x0[3 * k + c];
        this.x[3 * k + c] = rest + size * (this.xs[c][a + k] - rest);
      }
      let dot = 0;
      for (let c = 0; c < 4; ++c) dot += this.q0[4 * k + c] * this.qs[c][a + k];
      for (let c = 0; c < 4; ++c) {
        const rest = this.q0[4 * k + c];
        this.q[4 * k + c] = rest + size * (Math.sign(dot || 1) * this.qs[c][a + k] - rest);
      }
      normalise(this.q, 4 * k);
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
 * What of a body's shape is deformation, seen from its chord: the straight line between its first
 * and its last node, which stay where they are whatever the scale, so that no joint opens.
 *   d = x - lerp(x_a, x_b) - Q (X - lerp(X_a, X_b)),  Q: mean turn of the nodes
 * Displayed is x + (scale - 1) d; tangents along an element likewise.
 */
export class Chord {
  constructor(body) {
    this.body = body;
    this.turn = new Quaternion();
    this.last = body.nodes - 1;
    this.share = new Float32Array(body.nodes);  // of the length up to each node
    let length = 0;
    for (let k = 1; k < body.nodes; ++k) {
      length += distance(body.x0, k - 1, k);
      this.share[k] = length;
    }
    for (let k = 1; k < body.nodes; ++k) this.share[k] /= length || 1;
    this.length = length;
    this.d = new Float32Array(3 * body.nodes);
    this.v = new Vector3();
  }

  update() {
    const { body, last, turn, v } = this;
    meanTurn(body, turn);
    for (let k = 0; k < body.nodes; ++k) {
      const s = this.share[k];
      v.set(...[0, 1, 2].map((c) => body.x0[3 * k + c] - mix(body.x0, c, last, s))).applyQuaternion(turn);
      this.d[3 * k] = body.x[3 * k] - mix(body.x, 0, last, s) - v.x;
      this.d[3 * k + 1] = body.x[3 * k + 1] - mix(body.x, 1, last, s) - v.y;
      this.d[3 * k + 2] = body.x[3 * k + 2] - mix(body.x, 2, last, s) - v.z;
    }
  }

  /** Displayed place of node k. */
  place(k, scale, out) {
    const x = this.body.x, d = this.d, f = scale - 1;
    return out.set(x[3 * k] + f * d[3 * k], x[3 * k + 1] + f * d[3 * k + 1], x[3 * k + 2] + f * d[3 * k + 2]);
  }

  /** Displayed tangent of an element of this length at node k, dx/dxi. */
  tangent(k, length, scale, out) {
    const { body, last, turn, v } = this, f = scale - 1, share = length / (this.length || 1);
    axis(body.q, k, out).multiplyScalar(length);
    axis(body.q0, k, v).multiplyScalar(length);
    v.x -= share * (body.x0[3 * last] - body.x0[0]);
    v.y -= share * (body.x0[3 * last + 1] - body.x0[1]);
    v.z -= share * (body.x0[3 * last + 2] - body.x0[2]);
    v.applyQuaternion(turn);
    return out.set(
      out.x + f * (out.x - share * (body.x[3 * last] - body.x[0]) - v.x),
      out.y + f * (out.y - share * (body.x[3 * last + 1] - body.x[1]) - v.y),
      out.z + f * (out.z - share * (body.x[3 * last + 2] - body.x[2]) - v.z));
  }

  /** |d| at node k. */
  size(k) {
    return Math.hypot(this.d[3 * k], this.d[3 * k + 1], this.d[3 * k + 2]);
  }
}

function mix(x, c, last, s) {
  return (1 - s) * x[c] + s * x[3 * last + c];
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
