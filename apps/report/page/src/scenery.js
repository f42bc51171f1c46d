// What stands about the bodies: rigid bodies, joints, the grid.

import {
  BoxGeometry, BufferAttribute, BufferGeometry, ConeGeometry, CylinderGeometry, Group, LineSegments, Mesh, Quaternion,
  SphereGeometry, Vector3,
} from 'three';
import { lines, surface } from './materials.js';

const kUp = new Vector3(0, 1, 0);
const kA = new Vector3(), kB = new Vector3(), kQ = new Quaternion();

/** A rigid body: a block at its centre of mass, struts to its points and joints. */
export class RigidView {
  constructor(body, places, size) {
    this.body = body;
    this.material = surface(0x8a929c);
    this.mesh = new Group();
    const centre = new Vector3(...body.points.slice(0, 3)), r = 0.013 * size;
    const block = new Mesh(new BoxGeometry(2 * r, 2 * r, 2 * r), this.material);
    block.position.copy(centre);
    this.mesh.add(block);
    const ends = [new Vector3(), ...places];
    for (let i = 3; i < body.points.length; i += 3) ends.push(new Vector3(...body.points.slice(i, i + 3)));
    for (const end of ends)
      if (end.distanceTo(centre) > 1.5 * r) this.mesh.add(strut(centre, end, 0.3 * r, this.material));
  }

  update() {
    this.mesh.position.fromArray(this.body.x, 0);
    if (this.follows) this.mesh.position.add(this.follows);  // what it hangs on is drawn elsewhere (closure.js)
    this.mesh.quaternion.fromArray(this.body.q, 0);
  }
}

function strut(from, to, radius, material) {
  const way = new Vector3().subVectors(to, from);
  const mesh = new Mesh(new CylinderGeometry(radius, radius, way.length(), 10), material);
  mesh.position.copy(from).addScaledVector(way, 0.5);
  mesh.quaternion.setFromUnitVectors(kUp, way.normalize());
  return mesh;
}

const kShapes = {
  revolute: (r) => new CylinderGeometry(r, r, 2.6 * r, 20),
  cylindrical: (r) => new CylinderGeometry(0.7 * r, 0.7 * r, 4.5 * r, 20),
  screw: (r) => new CylinderGeometry(0.7 * r, 0.7 * r, 4.5 * r, 6),
  prismatic: (r) => new BoxGeometry(1.5 * r, 4 * r, 1.5 * r),
  planar: (r) => new CylinderGeometry(2 * r, 2 * r, 0.4 * r, 20),
  spherical: (r) => new SphereGeometry(1.2 * r, 20, 12),
  universal: (r) => new SphereGeometry(1.1 * r, 8, 6),
  fixed: (r) => new BoxGeometry(1.7 * r, 1.7 * r, 1.7 * r),
};

export const kLinks = ['rod', 'cylinder'];  // joints that are bodies without mass
const kC = new Vector3();

/** A joint at its second port, by the shape of its motion; a foot below where it is tied to the
    ground. */
export class JointView {
  /** @param port function(name, node, place, out): displayed place; turn(name, node, out) */
  constructor(joint, radius, up) {
    this.joint = joint;
    this.mesh = new Group();
    const material = surface(0xd9822b);
    if (kLinks.includes(joint.type)) {  // from port to port, as long as it is now
      this.link = new Mesh(new CylinderGeometry(0.45 * radius, 0.45 * radius, 1, 12), surface(0x8a929c));
      this.mesh.add(this.link);
    }
    const shape = (kShapes[joint.type] ?? kShapes.spherical)(radius);
    this.glyph = new Mesh(shape, material);
    this.axis = new Vector3(...(joint.axis.length ? joint.axis : [0, 0, 1]));
    this.mesh.add(this.glyph);
    this.grounded = joint.bodies.indexOf('ground');
    if (this.grounded >= 0) {
      this.foot = new Mesh(new ConeGeometry(2.2 * radius, 2.6 * radius, 4), surface(0x6b7480));
      const down = joint.type === 'prismatic' ? 2.2 * radius : 1.3 * radius;
      this.foot.quaternion.setFromUnitVectors(kUp, up);
      this.offset = up.clone().multiplyScalar(-down - 0.4 * radius);
      this.mesh.add(this.foot);
    }
  }

  update(frames) {
    const { joint } = this, end = joint.bodies[1] === 'ground' ? 0 : 1;
    frames.place(joint.bodies[end], joint.nodes[end], joint.places, 3 * end, kA);
    frames.turn(joint.bodies[1], joint.nodes[1], kQ);
    kB.copy(this.axis).applyQuaternion(kQ);
    this.glyph.position.copy(kA);
    this.glyph.quaternion.setFromUnitVectors(kUp, kB);
    if (this.link) {
      frames.place(joint.bodies[1 - end], joint.nodes[1 - end], joint.places, 3 * (1 - end), kB);
      kC.subVectors(kB, kA);
      this.link.position.copy(kA).addScaledVector(kC, 0.5);
      this.link.scale.y = kC.length() || 1e-9;
      this.link.quaternion.setFromUnitVectors(kUp, kC.normalize());
    }
    if (this.foot) {
      frames.place('ground', 0, joint.places, 3 * this.grounded, kB);
      this.foot.position.copy(joint.type === 'prismatic' || this.link ? kB : kA).add(this.offset);
    }
  }
}

/** Grid of about 16 squares a side with a round spacing, normal to `up`, at the height of `low`. */
export function grid(box, up, low, colour) {
  const size = box.getSize(new Vector3()).length(), raw = size / 12;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= raw);
  const half = 12, ends = [];
  for (let i = -half; i <= half; ++i) ends.push(-half, 0, i, half, 0, i, i, 0, -half, i, 0, half);
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(ends, (x) => x * step), 3));
  const helper = new LineSegments(geometry, lines(colour, 0.55));
  helper.quaternion.setFromUnitVectors(kUp, up);
  const centre = box.getCenter(new Vector3()).divideScalar(step).round().multiplyScalar(step);
  helper.position.copy(centre).addScaledVector(up, low - centre.dot(up));
  return { helper, step };
}
