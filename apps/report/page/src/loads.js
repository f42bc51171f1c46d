// The loads of a cycle at one of its instants, as arrows on the parts.

import { ConeGeometry, CylinderGeometry, Group, InstancedMesh, Matrix4, Quaternion, Vector3 } from 'three';
import { array } from './data.js';
import { surface } from './materials.js';

const kLongest = 0.2;  // arrow of the largest force, of the size of the mechanism
const kShortest = 0.004;  // below, a force is not drawn
const kUp = new Vector3(0, 1, 0), kF = new Vector3(), kX = new Vector3(), kQ = new Quaternion(), kM = new Matrix4(), kS = new Vector3();

/** Loads of the page's data: [{cycle, scenario, body, at, nodes, load, largest, moment}], N and N m. */
export function readLoads(list) {
  return (list ?? []).map((d) => {
    const load = array(d.load), part = { ...d, load, largest: 0, moment: 0 };
    for (let k = 0; k < d.nodes; ++k) {
      part.largest = Math.max(part.largest, Math.hypot(...load.slice(6 * k, 6 * k + 3)));
      part.moment = Math.max(part.moment, Math.hypot(...load.slice(6 * k + 3, 6 * k + 6)));
    }
    return part;
  });
}

/** Forces on the nodes of beams and the interfaces of meshed parts; one scale for all cycles. */
export class LoadArrows {
  constructor(view, loads) {
    this.view = view;
    this.unit = (kLongest * view.size) / Math.max(1e-300, ...loads.map((l) => l.largest));
    const most = Math.max(1, ...loads.map((l) => l.nodes)) * Math.max(1, new Set(loads.map((l) => l.body)).size);
    const r = 0.0035 * view.size;
    this.head = 5 * r;
    const material = surface(0xc8453b);
    this.shafts = new InstancedMesh(new CylinderGeometry(r, r, 1, 8).translate(0, 0.5, 0), material, most);
    this.heads = new InstancedMesh(new ConeGeometry(2.4 * r, this.head, 12).translate(0, 0.5 * this.head, 0), material, most);
    this.mesh = new Group();
    for (const mesh of [this.shafts, this.heads]) {
      mesh.frustumCulled = false;
      mesh.count = 0;
      this.mesh.add(mesh);
    }
    view.scene.add(this.mesh);
    view.arrows = this;
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
        this.view.place(part.body, node, [0, 0, 0], 0, kX);
        kQ.setFromUnitVectors(kUp, kF);
        const shaft = Math.max(length - this.head, 0.1 * length), head = Math.min(1, length / this.head);
        this.shafts.setMatrixAt(count, kM.compose(kX, kQ, kS.set(1, shaft, 1)));
        this.heads.setMatrixAt(count, kM.compose(kX.addScaledVector(kF, shaft), kQ, kS.set(head, head, head)));
        ++count;
      }
    }
    for (const mesh of [this.shafts, this.heads]) {
      mesh.count = count;
      mesh.instanceMatrix.needsUpdate = true;
    }
    this.view.canvas.dataset.arrows = count;
  }
}

/** Node of the final model: a refined one has more, at the same places. */
function nodeOf(part, k, body) {
  return part.nodes === body.nodes || !body.elements.length ? k : Math.round((k * (body.nodes - 1)) / (part.nodes - 1 || 1));
}
