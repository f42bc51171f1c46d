// Joints stay closed where deformation is drawn larger than it is: a body is drawn about the line between its outermost
// joints, and what is joined to it elsewhere is taken along as far as it is drawn away there.

import { Vector3 } from 'three';
import { kLinks } from './scenery.js';

const kSweeps = 4;  // over points on bodies that are taken along themselves
const kNone = new Vector3(), kA = new Vector3(), kB = new Vector3();

/** Places of bodies that joints hold together: all are drawn moved by one shift. */
class Point {
  constructor() {
    this.shift = new Vector3();
    this.held = false;     // it stays where it is: on the ground
    this.between = [];     // [{carried, node}]: bodies on which it lies between the ends of their line
  }
}

/** A flexible body: `view` has anchors [first, last], share(node) of the line between them, bend(node, out), and shift(a, b, bumps). */
class Carried {
  /** @param nodes node -> {point, joined}: places of joints; of links, which are as long as they have to be, `joined` is false */
  constructor(view, nodes) {
    const sorted = [...nodes.keys()].sort((a, b) => a - b), joined = sorted.filter((n) => nodes.get(n).joined);
    if (view.chord && joined.length > 1) view.chord.between(joined[0], joined[joined.length - 1]);
    this.view = view;
    this.single = joined.length === 1 ? joined[0] : null;
    const ends = this.single === null ? view.anchors : [this.single];
    this.ends = ends.map((n) => nodes.get(n)?.point ?? null);
    this.inner = sorted.filter((n) => !ends.includes(n)).map((node) => ({ node, point: nodes.get(node).point }));
    for (const { node, point } of this.inner) point.between.push({ carried: this, node });
  }

  /** Shifts at both ends of the line, for deformation that is drawn `more` times larger than it is. */
  base(more, a, b) {
    const { ends: [first, last], single, view } = this;
    if (single !== null) {
      b.copy(a.copy(first.shift).addScaledVector(view.bend(single, kBend), -more));
      return;
    }
    a.copy((first ?? last)?.shift ?? kNone);
    b.copy((last ?? first)?.shift ?? kNone);
  }

  /** Where a node would be drawn, from where it is. */
  away(node, more, out) {
    this.base(more, out, kEnd);
    return out.lerp(kEnd, this.view.share(node)).addScaledVector(this.view.bend(node, kBend), more);
  }

  apply(more) {
    const bumps = [];
    for (const { node, point } of this.inner) {
      const by = new Vector3().copy(point.shift).sub(this.away(node, more, kAway));
      if (by.lengthSq() > 1e-12 * kAway.lengthSq()) bumps.push({ node, by });
    }
    this.base(more, kA, kB);
    this.view.shift(kA, kB, bumps);
  }
}
const kBend = new Vector3(), kEnd = new Vector3(), kAway = new Vector3();

export class Closure {
  /** @param parts [{view, body}]  @param joints those of the page's data that have places */
  constructor(parts, joints) {
    this.views = new Map(parts.map(({ view, body }) => [body.name, view]));
    this.places = new Map();  // "body|node"; a rigid body is one place -> {body, node, point, joined}
    for (const joint of joints) this.join(joint);
    this.bodies = [];
    for (const [name, view] of this.views) {
      const nodes = new Map([...this.places.values()].filter((p) => p.body === name).map((p) => [p.node, p]));
      if (view.bend) this.bodies.push(new Carried(view, nodes));
      else view.follows = this.shiftOf(name, 0);
    }
    this.points = [...new Set([...this.places.values()].map((p) => p.point))].filter((p) => p.between.length && !p.held);
  }

  join(joint) {
    const link = kLinks.includes(joint.type), [a, b] = [0, 1].map((end) => this.placeOf(joint.bodies[end], joint.nodes[end], !link));
    if (link) return;
    if (!a || !b) {
      for (const place of [a, b]) if (place) place.point.held = true;
      return;
    }
    const { point } = a;
    b.point.held ||= point.held;
    for (const place of this.places.values()) if (place.point === point) place.point = b.point;
  }

  keyOf(body, node) { return this.views.get(body).bend ? `${body}|${node}` : body; }

  /** Null on the ground. */
  placeOf(body, node, joined) {
    if (!this.views.has(body)) return null;
    const key = this.keyOf(body, node);
    if (!this.places.has(key)) this.places.set(key, { body, node, point: new Point(), joined: false });
    const place = this.places.get(key);
    place.joined ||= joined;
    return place;
  }

  /** @param more how many times deformation is drawn larger than it is, less one */
  update(more) {
    for (const point of this.points) point.shift.set(0, 0, 0);
    for (let sweep = 0; more !== 0 && sweep < kSweeps; ++sweep)
      for (const { shift, between } of this.points) {
        kSum.set(0, 0, 0);
        for (const { carried, node } of between) kSum.add(carried.away(node, more, kAway));
        shift.copy(kSum).divideScalar(between.length);
      }
    for (const body of this.bodies) body.apply(more);
  }

  /** How far a place of a joint is drawn from where it is. */
  shiftOf(name, node) {
    return (this.views.has(name) && this.places.get(this.keyOf(name, node))?.point.shift) || kNone;
  }
}
const kSum = new Vector3();
