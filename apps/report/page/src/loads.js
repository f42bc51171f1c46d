// The loads of a cycle at one of its instants, as arrows on the parts.

import { ConeGeometry, CylinderGeometry, Group, Mesh, Quaternion, Vector3 } from 'three';
import { array, components } from './data.js';
import { surface } from './materials.js';

const kLongest = 0.3;  // arrow of the largest force, of the size of the mechanism
const kShortest = 0.004;  // below, a force is not drawn
const kUp = new Vector3(0, 1, 0), kF = new Vector3(), kX = new Vector3(), kQ = new Quaternion();

/** Loads of the page's data: [{cycle, scenario, body, at, nodes, load [6 nodes], places, largest, moment}], N and N m. */
export function readLoads({ cases, load }) {
  const all = components(load, cases.reduce((sum, c) => sum + c.nodes, 0));
  let first = 0;
  return cases.map((c) => {
    const part = { ...c, load: new Float32Array(6 * c.nodes), places: c.places && array(c.places), largest: 0, moment: 0 };
    for (let k = 0; k < c.nodes; ++k, ++first) {
      const f = all.map((component) => component[first]);
      part.load.set(f, 6 * k);
      part.largest = Math.max(part.largest, Math.hypot(...f.slice(0, 3)));
      part.moment = Math.max(part.moment, Math.hypot(...f.slice(3)));
    }
    return part;
  });
}

/** As many arrows as are needed; in the picture with the view's next update. */
export class Arrows {
  constructor(view) {
    this.view = view;
    const r = 0.0035 * view.size;
    this.head = 5 * r;
    this.material = surface(0xc8453b);
    this.shaft = new CylinderGeometry(r, r, 1, 8).translate(0, 0.5, 0);
    this.tip = new ConeGeometry(2.4 * r, this.head, 12).translate(0, 0.5 * this.head, 0);
    this.mesh = new Group();
    this.arrows = [];  // [shaft, head], as many as were ever shown
    view.scene.add(this.mesh);
    view.arrows = this;
  }

  /** Arrow k from a place along a direction of length 1. */
  put(k, from, along, length) {
    if (k === this.arrows.length) {
      this.arrows.push([new Mesh(this.shaft, this.material), new Mesh(this.tip, this.material)]);
      this.mesh.add(...this.arrows[k]);
    }
    const [shaft, head] = this.arrows[k], straight = Math.max(length - this.head, 0.1 * length), size = Math.min(1, length / this.head);
    shaft.quaternion.setFromUnitVectors(kUp, along);
    head.quaternion.copy(shaft.quaternion);
    shaft.position.copy(from);
    shaft.scale.set(1, straight, 1);
    head.position.copy(from).addScaledVector(along, straight);
    head.scale.setScalar(size);
  }

  /** No more than these are seen. */
  end(count) {
    for (const [k, arrow] of this.arrows.entries()) for (const mesh of arrow) mesh.visible = k < count;
    this.view.canvas.dataset.arrows = count;
  }
}

/** Forces on the nodes of beams, on the interfaces and patches of meshed parts; one scale for all cycles. */
export class LoadArrows extends Arrows {
  constructor(view, loads) {
    super(view);
    this.unit = (kLongest * view.size) / Math.max(1e-300, ...loads.map((l) => l.largest));
    this.parts = [];
  }

  /** @param parts loads of one instant, a part each; [] hides them */
  show(parts) {
    this.parts = parts;
    this.view.set({});
  }

  update() {
    let count = 0;
    for (const part of this.parts) {
      const body = this.view.byName.get(part.body);
      if (!body) continue;
      for (let k = 0; k < part.nodes; ++k) {
        const node = nodeOf(part, k, body);
        kF.fromArray(part.load, 6 * k);
        const length = kF.length() * this.unit;
        if (length < kShortest * this.view.size) continue;
        this.view.turn(part.body, body.elements.length ? node : 0, kQ);  // of a meshed part the axes of its mesh
        kF.applyQuaternion(kQ).normalize();
        const solid = part.places && this.view.viewOf.get(part.body);
        if (solid?.place) solid.place(part.places, 3 * k, kX);
        else if (node < body.nodes) this.view.place(part.body, node, [0, 0, 0], 0, kX);
        else continue;
        this.put(count++, kX, kF, length);
      }
    }
    this.end(count);
  }
}

/** Node of the final model: a refined one has more, at the same places. */
function nodeOf(part, k, body) {
  return part.nodes === body.nodes || !body.elements.length ? k : Math.round((k * (body.nodes - 1)) / (part.nodes - 1 || 1));
}
