// A part under fixed loads: where it is held, and what acts on it in the load case that is shown.

import { Box3, BoxGeometry, ConeGeometry, Group, Mesh, Vector3 } from 'three';
import { el } from './dom.js';
import { quantity } from './format.js';
import { Arrows } from './loads.js';
import { surface } from './materials.js';

const kLongest = 0.13;  // arrow of the largest force, of the size of the part
const kUp = new Vector3(0, 1, 0), kX = new Vector3(), kF = new Vector3(), kFrom = new Vector3();
const kAxes = { x: new Vector3(1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) };
const kWords = { x: 'x', y: 'y', z: 'z', r: 'turn' };

/** Marks in the picture: a block where all displacements are held, else a cone along each that is; arrows for forces. */
export class FixedLoads extends Arrows {
  /** @param summary with `supports`, `fixed_loads`, `load_cases`, of the one meshed part of the view */
  constructor(view, summary) {
    super(view);
    this.summary = summary;
    this.solid = view.parts.find((p) => p.view.sizes)?.view;
    this.loads = summary.fixed_loads.map((d) => ({ ...d, size: Math.hypot(...d.force), at: d.points.flat() }));
    this.unit = (kLongest * view.size) / Math.max(1e-300, ...this.loads.map((l) => l.size));
    this.marks = [];  // {mesh, points, k, out}: tip of the mesh at a point, `out` in the axes of the part
    const group = new Group(), material = surface(0x6b7480);
    for (const support of summary.supports) this.addMarks(support, group, material);
    view.scene.add(group);
    for (let instant = 0; instant < view.t.length; ++instant) {  // room for the marks of all cases
      Object.assign(view, { instant }).update();
      for (const marks of [group, this.mesh]) view.box.union(new Box3().setFromObject(marks));
    }
    view.fit();
  }

  addMarks({ held, points }, group, material) {
    const r = 0.011 * this.view.size, at = points.flat(), axes = [...held].filter((c) => kAxes[c]), whole = this.isWhole(held);
    for (let k = 0; k < points.length; ++k)
      for (const axis of whole ? ['x'] : axes) {
        const out = kAxes[axis].clone().multiplyScalar(this.outward(points[k], kAxes[axis]));
        const mesh = new Mesh(whole ? new BoxGeometry(1.7 * r, 1.7 * r, 1.7 * r) : new ConeGeometry(r, 2 * r, 4), material);
        group.add(mesh);
        this.marks.push({ mesh, at, k, out, height: whole ? 0 : r });
      }
  }

  /** Are all displacements held? */
  isWhole(letters) {
    return [...letters].filter((c) => kAxes[c]).length === (this.solid.planar ? 2 : 3);
  }

  /** -1 where the part is on the side that an axis points to, else 1. */
  outward(point, axis) {
    const { x0, vertices } = this.solid;
    this.middle ??= new Vector3(...x0.map((c) => c.reduce((sum, x) => sum + x, 0) / vertices));
    return kX.set(...point).sub(this.middle).dot(axis) < 0 ? -1 : 1;
  }

  /** Those of the load case that is shown. */
  shown() {
    const { load_cases: cases } = this.summary, now = cases[Math.round(this.view.instant)];
    return this.loads.filter((load) => cases.length < 2 || load.load_case === now);
  }

  update() {
    const { solid, marks } = this, turn = solid.mesh.quaternion;
    for (const { mesh, at, k, out, height } of marks) {
      solid.place(at, 3 * k, kX);
      kF.copy(out).applyQuaternion(turn);
      mesh.position.copy(kX).addScaledVector(kF, height);
      mesh.quaternion.setFromUnitVectors(kUp, kF.negate());
    }
    let count = 0;
    for (const load of this.shown()) {
      const length = load.size * this.unit * this.view.phase;
      if (length < 1e-3 * this.view.size) continue;
      for (let k = 0; 3 * k < load.at.length; ++k) {
        kF.set(...load.force).normalize();
        const towards = this.outward(load.points[k], kF) < 0;  // it ends where it acts, outside of the part
        kF.applyQuaternion(turn);
        solid.place(load.at, 3 * k, kFrom);
        if (towards) kFrom.addScaledVector(kF, -length);
        this.put(count++, kFrom, kF, length);
      }
    }
    this.end(count);
  }

  /** What the marks are, in words. */
  legend() {
    const held = this.summary.supports.map(({ place, held: letters }) => (place === 'inertia_relief'
      ? el('span', {}, 'held nowhere: its inertia balances the loads')
      : el('span', {}, el('i', { class: 'held' }, this.isWhole(letters) ? '\u25a0' : '\u25b2'), ` held: ${place} (${[...letters].map((c) => kWords[c] ?? c).join(', ')})`)));
    const acts = ({ name, place, moment, size }) => {
      const turning = Math.hypot(...moment);
      const what = [size > 0 ? quantity(size, 'N', 3) : '', turning > 0 ? quantity(turning, 'N m', 3) : ''].filter(Boolean).join(' and ');
      return `${name}: ${what} on ${place}`;
    };
    return [...held,
      ...this.shown().map((load) => el('span', {}, el('i', { class: 'force' }, '\u2192'), ` ${acts(load)}`))];
  }
}
