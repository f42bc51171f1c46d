// A meshed part: what is material of its mesh, moved by its amplitudes in the frame of its first
// interface.

import { BufferAttribute, BufferGeometry, Mesh, Quaternion, Vector3 } from 'three';
import { array, components } from './data.js';
import { paint } from './colors.js';
import { surface } from './materials.js';

const kC = new Vector3(), kE = new Vector3(), kP = new Vector3(), kD = new Vector3(), kU = new Quaternion();

export class SolidView {
  /** @param body that of the same name: frames of the interfaces */
  constructor(d, body, instants) {
    this.body = body;
    this.planar = d.planar;
    this.half = d.thickness / 2;
    this.amplitudes = array(d.amplitude);
    this.count = d.basis.length;
    this.vertices = d.x0.find((c) => typeof c !== 'number')?.n ?? 0;
    this.x0 = components(d.x0, this.vertices);
    this.basis = d.basis.map((b) => components(b, this.vertices));
    this.stressBasis = d.stress.map((b) => components(b, this.vertices));
    this.stresses = new Float32Array(this.vertices);
    this.interfaces = d.interfaces;
    this.far = body.nodes > 1 ? farthest(d.interfaces) : 0;
    this.anchors = [0, this.far];  // of the chord
    this.moved = null;             // how joints that are drawn elsewhere take it along (closure.js)
    this.e = new Float32Array(this.count);
    this.u = new Float32Array(3 * this.vertices);
    this.sizes = new Float32Array(this.vertices);
    this.instants = instants;
    this.build(array(d.triangles), array(d.sides));
    this.value = this.sizes;
  }

  build(triangles, sides) {
    const V = this.vertices, index = Array.from(triangles);
    if (this.planar) {  // the other face, and the walls between both
      for (let i = 0; i < triangles.length; i += 3)
        index.push(V + triangles[i], V + triangles[i + 2], V + triangles[i + 1]);
      for (let i = 0; i < sides.length; i += 2) {
        const a = sides[i], b = sides[i + 1];
        index.push(a, V + a, V + b, a, V + b, b);
      }
    }
    const geometry = new BufferGeometry(), all = this.planar ? 2 * V : V;
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(3 * all), 3));
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(3 * all), 3));
    geometry.setIndex(new BufferAttribute(new Uint32Array(index), 1));
    this.mesh = new Mesh(geometry, surface(0xffffff, true));
    this.mesh.frustumCulled = false;
  }

  at(i, s) {
    const k = this.count, a = i * k, b = Math.min(i + 1, this.instants - 1) * k;
    for (let c = 0; c < k; ++c) this.e[c] = (1 - s) * this.amplitudes[a + c] + s * this.amplitudes[b + c];
  }

  /** Von Mises stress of the vertices, of the full material. @returns the largest */
  stress() {
    const { stressBasis, e, stresses } = this, n = stressBasis[0]?.length ?? 0, sigma = new Float64Array(6);
    let largest = 0;
    for (let v = 0; n > 0 && v < this.vertices; ++v) {
      sigma.fill(0);
      for (let k = 0; k < this.count; ++k) for (let c = 0; c < n; ++c) sigma[c] += e[k] * stressBasis[k][c][v];
      stresses[v] = n === 3 ? planeStress(sigma) : spaceStress(sigma);
      largest = Math.max(largest, stresses[v]);
    }
    return largest;
  }

  /** `size` times the deformation u of the vertices, and its size seen from the chord, between the first interface
      and the one farthest from it. */
  deform(size) {
    const { u, e, basis, vertices } = this;
    u.fill(0);
    for (let k = 0; k < this.count; ++k)
      for (let c = 0; c < 3; ++c) {
        const psi = basis[k][c], f = size * e[k];
        if (f !== 0) for (let v = 0; v < vertices; ++v) u[3 * v + c] += f * psi[v];
      }
    this.findChord();
  }

  /** Turn of the chord, in the axes of the frame, and what is left of it: its elongation. */
  findChord() {
    const { body, interfaces, far } = this;
    this.turn = (this.turn ?? new Quaternion()).identity();
    this.stretch = (this.stretch ?? new Vector3()).set(0, 0, 0);
    if (!far) return;
    kU.fromArray(body.q, 0).conjugate();
    kE.set(...[0, 1, 2].map((c) => body.x[3 * far + c] - body.x[c])).applyQuaternion(kU);
    kC.fromArray(interfaces, 3 * far);
    this.length2 = kC.lengthSq();
    this.c0 = (this.c0 ?? new Vector3()).copy(kC);
    kP.copy(kC).normalize();
    this.turn.setFromUnitVectors(kP, kQv.copy(kE).normalize());
    this.stretch.copy(kE).sub(kC.applyQuaternion(this.turn));
  }

  /** Of a place of the part along the chord. */
  shareAt(x, y, z) {
    return this.far ? (x * this.c0.x + y * this.c0.y + z * this.c0.z) / this.length2 : 0;
  }
  share(node) {
    return this.shareAt(...this.interfaces.slice(3 * node, 3 * node + 3));
  }

  /** What of the place of an interface is deformation, in the axes of the scene. */
  bend(node, out) {
    const { body, interfaces } = this;
    kU.fromArray(body.q, 0);
    out.set(...[0, 1, 2].map((c) => body.x[3 * node + c] - body.x[c])).applyQuaternion(kBack.copy(kU).conjugate());
    kC.fromArray(interfaces, 3 * node);
    const share = this.shareAt(kC.x, kC.y, kC.z);
    return out.sub(kC.applyQuaternion(this.turn).addScaledVector(this.stretch, share)).applyQuaternion(kU);
  }

  /** Takes the part along: by a at the first interface, by b at the other end of the chord, by bumps {node, by} about others. */
  shift(a, b, bumps) {
    this.moved = null;
    if (a.lengthSq() + b.lengthSq() === 0 && !bumps.length) return;
    const back = kU.fromArray(this.body.q, 0).conjugate(), turned = (v) => new Vector3().copy(v).applyQuaternion(back);
    this.moved = { a: turned(a), b: turned(b), bumps: bumps.map(({ node, by }) => {
      const at = new Vector3().fromArray(this.interfaces, 3 * node);
      let square = Infinity;
      for (let i = 0; 3 * i < this.interfaces.length; ++i)
        if (i !== node) square = Math.min(square, at.distanceToSquared(kC.fromArray(this.interfaces, 3 * i)));
      return { at, by: turned(by), square };
    }) };
  }

  /** kD: how far a place of the part is taken along. */
  along(x, y, z) {
    const { a, b, bumps } = this.moved;
    kD.copy(a).lerp(b, this.shareAt(x, y, z));
    for (const { at, by, square } of bumps) {
      const left = 1 - ((x - at.x) ** 2 + (y - at.y) ** 2 + (z - at.z) ** 2) / square;
      if (left > 0) kD.addScaledVector(by, left * left);
    }
  }

  update(scale, colour, plain) {
    const { x0, u, vertices, half, planar, body, mesh } = this;
    const position = mesh.geometry.attributes.position.array, out = mesh.geometry.attributes.color.array;
    mesh.position.fromArray(body.x, 0);
    mesh.quaternion.fromArray(body.q, 0);
    const f = scale - 1;
    for (let v = 0; v < vertices; ++v) {
      const x = x0[0][v], y = x0[1][v], z = x0[2][v], at = 3 * v;
      this.sizes[v] = this.deformation(x, y, z, at);
      let px = x + u[at] + f * kP.x, py = y + u[at + 1] + f * kP.y, pz = z + u[at + 2] + f * kP.z;
      if (this.moved) {
        this.along(x, y, z);
        px += kD.x;
        py += kD.y;
        pz += kD.z;
      }
      position[at] = px;
      position[at + 1] = py;
      position[at + 2] = planar ? pz + half : pz;
      if (colour) paint(colour.map, (this.value[v] - colour.low) / (colour.high - colour.low || 1), out, at);
      else plain.toArray(out, at);
    }
    if (planar) this.copyFace(position, out);
    mesh.geometry.attributes.position.needsUpdate = true;
    mesh.geometry.attributes.color.needsUpdate = true;
  }

  /** kP = u - ((Q - I) X + share of the elongation): what is deformation. @returns its size */
  deformation(x, y, z, at) {
    const { u, turn } = this;
    kP.set(x, y, z);
    const share = this.far ? kP.dot(this.c0) / this.length2 : 0;
    kP.applyQuaternion(turn).addScaledVector(this.stretch, share);
    kP.set(u[at] + x - kP.x, u[at + 1] + y - kP.y, u[at + 2] + z - kP.z);
    return kP.length();
  }

  /** Where a place of the part is drawn: it moves as the vertex next to it, on the front face. */
  place(places, at, out) {
    const { x0, vertices, mesh, planar, half } = this, position = mesh.geometry.attributes.position.array;
    const [x, y, z] = [places[at], places[at + 1], places[at + 2]];
    let best = 0, nearest = Infinity;
    for (let v = 0; v < vertices; ++v) {
      const away = (x0[0][v] - x) ** 2 + (x0[1][v] - y) ** 2 + (x0[2][v] - z) ** 2;
      if (away < nearest) [best, nearest] = [v, away];
    }
    out.set(x + position[3 * best] - x0[0][best], y + position[3 * best + 1] - x0[1][best], planar ? half : z + position[3 * best + 2] - x0[2][best]);
    return out.applyQuaternion(mesh.quaternion).add(mesh.position);
  }

  copyFace(position, colours) {
    const V = 3 * this.vertices;
    for (let at = 0; at < V; at += 3) {
      position[V + at] = position[at];
      position[V + at + 1] = position[at + 1];
      position[V + at + 2] = position[at + 2] - 2 * this.half;
    }
    colours.copyWithin(V, 0, V);
  }
}
const kQv = new Vector3(), kBack = new Quaternion();

function planeStress([x, y, xy]) {
  return Math.sqrt(Math.max(0, x * x - x * y + y * y + 3 * xy * xy));
}
function spaceStress([x, y, z, a, b, c]) {
  return Math.sqrt(Math.max(0, 0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) + 3 * (a * a + b * b + c * c)));
}

/** Number of the interface farthest from the first; 0 if there is no other. */
function farthest(places) {
  let far = 0, most = 0;
  for (let i = 1; 3 * i < places.length; ++i) {
    const size = Math.hypot(places[3 * i], places[3 * i + 1], places[3 * i + 2]);
    if (size > most) [far, most] = [i, size];
  }
  return far;
}
