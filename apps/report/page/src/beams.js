// A beam as a solid: each element with its own section, between its nodes a cubic.

import { BufferAttribute, BufferGeometry, Mesh, Vector3 } from 'three';
import { paint } from './colors.js';
import { surface } from './materials.js';
import { Chord } from './motion.js';
import { outline, radius } from './sections.js';

const kMostStations = 400;  // of a body, beyond which elements are drawn straight

export class BeamView {
  constructor(body, modelSize) {
    this.body = body;
    this.chord = new Chord(body);
    this.fallback = 0.006 * modelSize;
    this.parts = Math.max(1, Math.min(6, Math.floor(kMostStations / body.elements.length / 2)));
    this.mesh = new Mesh(new BufferGeometry(), surface());
    this.mesh.frustumCulled = false;
    this.value = new Float32Array(body.nodes);
    this.ends = new Float32Array(2 * body.elements.length);  // of the elements: what a node has need not be continuous
    this.setSections(null);
  }

  /** @param changed element -> its dimensions, where they are others than those of the result */
  setSections(changed) {
    const { body } = this;
    this.sections = body.elements.map((_, e) => {
      const own = body.dimensions.slice(4 * e, 4 * e + 4);
      return outline(body.shapes[e], changed?.get(e) ?? own, this.fallback);
    });
    this.build();
  }

  radiusAt(node) {
    const touching = this.body.elements.flatMap((e, i) => (e.includes(node) ? [radius(this.sections[i])] : []));
    return touching.length ? Math.max(...touching) : 0;
  }

  // What closure.js asks of a body.
  get anchors() { return this.chord.anchors; }
  share(node) { return this.chord.share[node]; }
  bend(node, out) { return out.fromArray(this.chord.d, 3 * node); }
  shift(a, b, bumps) { this.chord.shift(a, b, bumps); }

  /** Vertices of a station: [y, z, n_y, n_z, end], end = -1 or 1 on the faces at both ends. */
  build() {
    const rows = [], index = [];
    this.stations = [];  // element, xi, first row, rows
    for (const [e, section] of this.sections.entries()) {
      const first = this.stations.length;
      for (let p = 0; p <= this.parts; ++p) {
        this.stations.push({ e, xi: p / this.parts, first: rows.length });
        for (const loop of section.loops) addRing(loop, rows);
        this.stations[this.stations.length - 1].end = rows.length;
      }
      for (let p = 0; p < this.parts; ++p)
        addSides(this.stations[first + p].first, this.stations[first + p + 1].first, section, index);
      addCap(section, e, 0, -1, rows, index, this.stations);
      addCap(section, e, 1, 1, rows, index, this.stations);
    }
    const geometry = new BufferGeometry();
    this.rows = Float32Array.from(rows.flat());
    for (const name of ['position', 'normal', 'color'])
      geometry.setAttribute(name, new BufferAttribute(new Float32Array(3 * rows.length), 3));
    geometry.setIndex(index);
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }

  /** Values of the nodes as those of the ends of elements. */
  spread() {
    for (const [e, [i, j]] of this.body.elements.entries()) {
      this.ends[2 * e] = this.value[i];
      this.ends[2 * e + 1] = this.value[j];
    }
  }

  /** Places and colours. @param colour null: plain, else {map, low, high} of `this.ends` */
  update(scale, colour, plain) {
    const { mesh, rows } = this;
    const position = mesh.geometry.attributes.position.array, normal = mesh.geometry.attributes.normal.array,
      paintTo = mesh.geometry.attributes.color.array;
    for (const station of this.stations) {
      this.frame(station, scale);
      const value = (1 - station.xi) * this.ends[2 * station.e] + station.xi * this.ends[2 * station.e + 1];
      for (let v = station.first; v < station.end; ++v) {
        const y = rows[5 * v], z = rows[5 * v + 1], ny = rows[5 * v + 2], nz = rows[5 * v + 3], nt = rows[5 * v + 4];
        const at = 3 * v;
        position[at] = kX.x + y * kY.x + z * kZ.x;
        position[at + 1] = kX.y + y * kY.y + z * kZ.y;
        position[at + 2] = kX.z + y * kY.z + z * kZ.z;
        normal[at] = ny * kY.x + nz * kZ.x + nt * kT.x;
        normal[at + 1] = ny * kY.y + nz * kZ.y + nt * kT.y;
        normal[at + 2] = ny * kY.z + nz * kZ.z + nt * kT.z;
        if (colour) paint(colour.map, (value - colour.low) / (colour.high - colour.low || 1), paintTo, at);
        else plain.toArray(paintTo, at);
      }
    }
    for (const name of ['position', 'normal', 'color']) mesh.geometry.attributes[name].needsUpdate = true;
  }

  /** Centre kX and axes kT, kY, kZ of a station: cubic through the displayed nodes. */
  frame({ e, xi }, scale) {
    const { body, chord } = this, [i, j] = body.elements[e];
    const length = Math.hypot(...[0, 1, 2].map((c) => body.x0[3 * j + c] - body.x0[3 * i + c]));
    chord.place(i, scale, kA);
    chord.place(j, scale, kB);
    chord.tangent(i, j, i, length, scale, kU);
    chord.tangent(i, j, j, length, scale, kV);
    const s = xi, s2 = s * s, s3 = s2 * s;
    combine(kX, 2 * s3 - 3 * s2 + 1, s3 - 2 * s2 + s, 3 * s2 - 2 * s3, s3 - s2);
    combine(kT, 6 * s2 - 6 * s, 3 * s2 - 4 * s + 1, 6 * s - 6 * s2, 3 * s2 - 2 * s);
    kT.normalize();
    secondAxis(body.q, i, j, s, kY);
    kY.addScaledVector(kT, -kY.dot(kT)).normalize();
    kZ.crossVectors(kT, kY);
  }
}

const kA = new Vector3(), kB = new Vector3(), kU = new Vector3(), kV = new Vector3();
const kX = new Vector3(), kT = new Vector3(), kY = new Vector3(), kZ = new Vector3();

function combine(out, a, u, b, v) {
  out.set(0, 0, 0).addScaledVector(kA, a).addScaledVector(kU, u).addScaledVector(kB, b).addScaledVector(kV, v);
}

/** Second axis of the frame between those of two nodes. */
function secondAxis(q, i, j, s, out) {
  let dot = 0;
  for (let c = 0; c < 4; ++c) dot += q[4 * i + c] * q[4 * j + c];
  const b = dot < 0 ? -s : s, a = 1 - s;
  const x = a * q[4 * i] + b * q[4 * j], y = a * q[4 * i + 1] + b * q[4 * j + 1],
    z = a * q[4 * i + 2] + b * q[4 * j + 2], w = a * q[4 * i + 3] + b * q[4 * j + 3];
  return out.set(2 * (x * y - z * w), w * w - x * x + y * y - z * z, 2 * (y * z + x * w));
}

function addRing(loop, rows) {
  const n = loop.points.length, sign = loop.inner ? -1 : 1;
  for (let i = 0; i < n; ++i) {
    const [y, z] = loop.points[i];
    if (loop.smooth) {
      const r = Math.hypot(y, z) || 1;
      rows.push([y, z, (sign * y) / r, (sign * z) / r, 0]);
      continue;
    }
    const [y2, z2] = loop.points[(i + 1) % n], r = Math.hypot(y2 - y, z2 - z) || 1;
    const ny = (sign * (z2 - z)) / r, nz = (sign * (y - y2)) / r;
    rows.push([y, z, ny, nz, 0], [y2, z2, ny, nz, 0]);
  }
}

function addSides(a, b, section, index) {
  let row = 0;
  for (const loop of section.loops) {
    const n = loop.points.length;
    for (let i = 0; i < n; ++i) {
      const p = loop.smooth ? row + i : row + 2 * i, q = loop.smooth ? row + ((i + 1) % n) : row + 2 * i + 1;
      index.push(a + p, a + q, b + q, a + p, b + q, b + p);
    }
    row += loop.smooth ? n : 2 * n;
  }
}

function addCap(section, e, xi, end, rows, index, stations) {
  const first = rows.length;
  for (const loop of section.loops) for (const [y, z] of loop.points) rows.push([y, z, 0, 0, end]);
  for (const [a, b, c] of section.caps)
    end > 0 ? index.push(first + a, first + b, first + c) : index.push(first + a, first + c, first + b);
  stations.push({ e, xi, first, end: rows.length });
}
