// The picture in space: bodies at an instant, deformation to scale, colours, camera.

import {
  Box3, Color, PerspectiveCamera, Quaternion, Scene, Vector3, WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/examples/jsm/controls/OrbitControls.js';
import { BeamView } from './beams.js';
import { Closure } from './closure.js';
import { array, components } from './data.js';
import { displacements, displacementsAt } from './displacements.js';
import { onTheme, theme } from './dom.js';
import { Body } from './motion.js';
import { quantities } from './quantities.js';
import { grid, JointView, RigidView } from './scenery.js';
import { SolidView } from './solids.js';

const kBodies = ['#7f9bb8', '#b8977f', '#86ad8c', '#a78fb5', '#b5a86f', '#7fb0b3'];
const kV = new Vector3(), kQ = new Quaternion();

/** Is it the processor that draws? */
function drawnBySoftware() {
  const gl = document.createElement('canvas').getContext('webgl2'), named = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = named ? gl.getParameter(named.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}

export class View {
  constructor(canvas, motion) {
    this.canvas = canvas;
    this.motion = motion;
    this.t = array(motion.t);
    this.modes = motion.abscissa === 'frequency';
    this.shapes = this.modes || motion.abscissa === 'load_case';  // each record a shape by itself
    this.fromRest = motion.abscissa !== 'time';  // displacements from rest are drawn larger, not deformation about chords
    this.bodies = motion.bodies.map((d) => new Body(d, this.t.length));
    this.byName = new Map(this.bodies.map((b) => [b.name, b]));
    Object.assign(this, { instant: 0, scale: 1, phase: 1, colour: null, dirty: true });
    this.plain = drawnBySoftware();
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.plain, preserveDrawingBuffer: true });
    this.plays(false);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 0.01, 100);
    this.measure();
    this.addBodies();
    this.addRanges();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => (this.dirty = true));
    onTheme(() => this.retheme());
    this.retheme();
    this.fit();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  /** Software has no time for smooth edges in each picture of a motion: they are drawn where it rests, by four points a pixel. */
  plays(on) {
    const ratio = Math.min(devicePixelRatio, 2);
    this.renderer.setPixelRatio(this.plain ? (on ? Math.min(ratio, 1) : 2) : ratio);
    this.dirty = true;
  }

  /** Box about all instants, the plane of a planar motion, and which way is up. */
  measure() {
    this.box = new Box3();
    for (const body of this.bodies) {
      const arms = body.elements.length ? [] : this.armsOf(body);  // what a rigid body reaches
      for (let i = 0; i < body.xs[0].length; i += Math.max(1, Math.floor(body.xs[0].length / 4000))) {
        this.box.expandByPoint(kV.set(body.xs[0][i], body.xs[1][i], body.xs[2][i]));
        kQ.set(...body.qs.map((c) => c[i])).normalize();
        for (const arm of arms)
          this.box.expandByPoint(kV.copy(arm).applyQuaternion(kQ).add(new Vector3(...body.xs.map((c) => c[i]))));
      }
    }
    for (const joint of this.motion.joints)  // places on the ground, with room for the foot below
      for (const end of [0, 1])
        if (joint.bodies[end] === 'ground' && joint.places.length && joint.type !== 'prismatic') this.box.expandByPoint(kV.fromArray(joint.places, 3 * end));
    for (const mesh of this.motion.meshes) this.addToBox(mesh);
    const size = this.box.getSize(new Vector3());
    this.size = size.length() || 1;
    const flat = [size.x, size.y, size.z].map((s) => s < 1e-6 * this.size);
    const normal = flat[2] ? 2 : flat[1] ? 1 : flat[0] ? 0 : -1;
    this.planar = this.motion.space === 'planar' && normal >= 0;
    this.up = new Vector3(...(this.planar && normal === 2 ? [0, 1, 0] : [0, 0, 1]));
    this.normal = new Vector3(...[0, 1, 2].map((c) => (this.planar && c === normal ? 1 : 0)));
    if (this.planar && normal === 1) this.normal.negate();
  }

  /** Vertices of a meshed part at rest. */
  addToBox(mesh) {
    const body = this.byName.get(mesh.name), n = mesh.x0.find((c) => typeof c !== 'number')?.n ?? 0;
    const x = components(mesh.x0, n), origin = new Vector3(...body.x0.slice(0, 3));
    kQ.fromArray(body.q0, 0);
    for (let i = 0; i < n; i += Math.max(1, Math.floor(n / 4000)))
      this.box.expandByPoint(kV.set(x[0][i], x[1][i], x[2][i]).applyQuaternion(kQ).add(origin));
  }

  addBodies() {
    const { motion, size } = this;
    this.parts = [];  // {view, body, plain}
    const solids = new Map(motion.meshes.map((m) => [m.name, m]));
    for (const [i, body] of this.bodies.entries()) {
      let view;
      if (body.elements.length > 0) view = new BeamView(body, size);
      else if (solids.has(body.name)) view = new SolidView(solids.get(body.name), body, this.t.length);
      else view = new RigidView(body, this.portsOf(body), size);
      this.parts.push({ view, body, plain: new Color(kBodies[i % kBodies.length]) });
      this.scene.add(view.mesh);
    }
    this.viewOf = new Map(this.parts.map((p) => [p.body.name, p.view]));
    const joints = motion.joints.filter((j) => j.places.length > 0);
    this.closure = new Closure(this.parts, joints);
    this.joints = joints.map((j) => new JointView(j, this.jointRadius(j), this.up));
    for (const joint of this.joints) this.scene.add(joint.mesh);
  }

  /** Points and places of joints of a body, in its axes. */
  armsOf(body) {
    const points = [];
    for (let i = 0; i < (body.points?.length ?? 0); i += 3) points.push(new Vector3(...body.points.slice(i, i + 3)));
    return [...points, ...this.portsOf(body)];
  }

  /** Places of joints on a body, in its axes. */
  portsOf(body) {
    return this.motion.joints.flatMap((j) =>
      [0, 1].filter((end) => j.bodies[end] === body.name && j.places.length)
        .map((end) => new Vector3(...j.places.slice(3 * end, 3 * end + 3))));
  }

  jointRadius(joint) {
    const around = joint.bodies.map((name, end) => this.viewOf.get(name)?.radiusAt?.(joint.nodes[end]) ?? 0);
    return Math.max(0.0095 * this.size, Math.min(1.12 * Math.max(...around), 0.03 * this.size));
  }

  /** Ranges of colours: forces and stresses from the records, deformations by looking at some. */
  addRanges() {
    let size = 0, stress = 0, ofRigid = 0;
    const n = this.t.length;
    this.largest = 0;  // instant of the largest deformation
    const few = this.shapes ? n : this.motion.meshes.length ? 60 : 600;  // instants to look at: vertices are many
    for (let i = 0; i < n; i += Math.max(1, Math.floor(n / few))) {
      const before = size;
      this.moveBodies(i, 0, 1);
      for (const { view, body } of this.parts) {
        if (view.sizes) stress = Math.max(stress, view.stress());
        if (view.bend) size = Math.max(size, this.sizeOf(view, body, i));
        else if (this.fromRest) ofRigid = Math.max(ofRigid, this.sizeOf(view, body, i));
      }
      if (size > before) this.largest = i;
    }
    this.deformed = size > 0 ? Math.max(size, ofRigid) : 0;
    const label = this.fromRest ? 'displacement' : 'deformation';  // else about the chord
    const deformation = { key: 'displacement', label, unit: 'm', map: 'size', size, low: 0, high: size };
    this.quantities = [...(size > 0 ? [deformation] : []), ...(this.modes ? [] : quantities(this.bodies, stress))];
  }

  /** Of a body at the record that it has been moved to, the largest of what is drawn larger. */
  sizeOf(view, body, i) {
    if (this.fromRest) return displacements(view, body, i).reduce((a, b) => Math.max(a, b), 0);
    let size = 0;
    view.chord?.update();
    for (let k = 0; view.chord && k < body.nodes; ++k) size = Math.max(size, view.chord.size(k));
    for (let v = 0; v < (view.vertices ?? 0); v += 7)
      size = Math.max(size, view.deformation(view.x0[0][v], view.x0[1][v], view.x0[2][v], 3 * v));
    return size;
  }

  /** A scale that shows the largest deformation as a tenth of the picture; 1, 2 or 5 times a power. */
  goodScale() {
    if (!(this.deformed > 0)) return 1;
    const raw = (0.06 * this.size) / this.deformed, power = 10 ** Math.floor(Math.log10(raw));
    return Math.max(1, [5, 2, 1].map((k) => k * power).find((k) => k <= raw * 1.001) ?? power);
  }

  /** @param size by which displacements from rest are drawn larger */
  moveBodies(i, s, size) {
    for (const { view, body } of this.parts) {
      body.at(i, s);
      body.enlarge(size);
      if (!view.at) continue;
      view.at(i, s);
      view.deform(size);
    }
  }

  /** Instant as a number of records, with its fraction; of modes the number, and the phase. */
  set(change) {
    Object.assign(this, change);
    this.dirty = true;
  }

  update() {
    const last = this.t.length - 1, i = Math.min(Math.floor(this.instant), last);
    const s = this.shapes ? 0 : Math.min(this.instant - i, 1);
    const scale = this.fromRest ? 1 : this.scale, sized = this.colour?.key === 'displacement';
    if (this.fromRest && sized) for (const { view, body } of this.parts) if (view.bend) view.fromRest = displacementsAt(view, body, i, s);
    this.moveBodies(i, s, this.fromRest ? this.phase * this.scale : 1);
    for (const { view } of this.parts) view.chord?.update();
    this.closure.update(scale - 1);
    for (const { view, body, plain } of this.parts) {
      const colour = this.colourOf(view, body, i, s);
      if (view.chord && colour && sized)
        for (let k = 0; k < body.nodes; ++k) view.value[k] = this.fromRest ? view.fromRest[k] : view.chord.size(k);
      if (view.spread && colour && this.colour.key !== 'stress') view.spread();
      view.update(scale, colour, plain);
    }
    for (const joint of this.joints) joint.update(this);
    this.arrows?.update();
  }

  /** What a body is coloured by now; null: plain. */
  colourOf(view, body, i, s) {
    if (!this.colour) return null;
    if (view.sizes) view.value = this.colour.key === 'stress' ? view.stresses : this.fromRest && this.colour.key === 'displacement' ? view.fromRest : view.sizes;
    if (view.sizes && this.colour.key === 'stress') view.stress();
    if (this.colour.key === 'displacement' || (view.sizes && this.colour.key === 'stress')) return this.colour;
    const field = this.colour.field(body);
    if (!field || !view.value || !body.elements.length) return null;
    body.values(field, i, s, this.colour.key === 'stress' ? view.ends : view.value);
    return this.colour;
  }

  /** Displayed place of a port. */
  place(name, node, places, at, out) {
    out.fromArray(places, at);
    const body = this.byName.get(name);
    if (!body) return out;
    out.applyQuaternion(this.turn(name, node, kQ));
    const view = this.viewOf.get(name);
    if (view.chord) return out.add(view.chord.place(node, this.fromRest ? 1 : this.scale, kV));
    return out.add(kV.fromArray(body.x, 3 * Math.min(node, body.nodes - 1))).add(this.closure.shiftOf(name, node));
  }
  turn(name, node, out) {
    const body = this.byName.get(name);
    return body ? out.fromArray(body.q, 4 * Math.min(node, body.nodes - 1)) : out.identity();
  }

  /** How far apart both sides of each joint are drawn, by name, m; for whoever measures. */
  openings() {
    this.update();
    return Object.fromEntries(this.joints.map(({ joint }) => [joint.name, this.drawn(joint, 0).distanceTo(this.drawn(joint, 1))]));
  }

  /** Where a side of a joint is on what is drawn: of meshed parts beside the nearest vertex, of rigid bodies on the block. */
  drawn(joint, end) {
    const name = joint.bodies[end], node = joint.nodes[end], view = this.viewOf.get(name), out = new Vector3();
    if (!view || view.chord) return this.place(name, node, joint.places, 3 * end, out);
    if (view.place) return view.place(view.interfaces, 3 * node, out);
    return out.fromArray(joint.places, 3 * end).applyQuaternion(view.mesh.quaternion).add(view.mesh.position);
  }

  /** Draws if anything has changed. @returns whether it did */
  draw() {
    if (!this.dirty) return false;
    this.dirty = false;
    this.update();
    this.renderer.render(this.scene, this.camera);
    return true;
  }

  /** The camera as near as the whole motion allows. */
  fit() {
    const centre = this.box.getCenter(new Vector3()), margin = (this.fromRest ? 0.1 : 0.05) * this.size;  // what moves from rest is magnified
    const from = this.planar
      ? this.normal.clone().addScaledVector(this.up, 0.2).addScaledVector(kV.crossVectors(this.up, this.normal), -0.1)
      : new Vector3(0.75, -1, 0.55);
    const w = from.normalize(), u = new Vector3().crossVectors(this.up, w).normalize(), v = new Vector3().crossVectors(w, u);
    const tan = Math.tan(((this.camera.fov / 2) * Math.PI) / 180), aspect = this.camera.aspect || 1;
    let away = 0;
    for (let corner = 0; corner < 8; ++corner) {
      kV.set(...[0, 1, 2].map((c) => ((corner >> c) & 1 ? this.box.max : this.box.min).getComponent(c))).sub(centre);
      away = Math.max(away, (Math.abs(kV.dot(u)) + margin) / (tan * aspect) + kV.dot(w), (Math.abs(kV.dot(v)) + margin) / tan + kV.dot(w));
    }
    this.camera.up.copy(this.up);
    this.camera.position.copy(centre).addScaledVector(w, away);
    this.camera.near = away / 100;
    this.camera.far = away * 20;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(centre);
    this.controls.update();
    this.dirty = true;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    const before = this.camera.aspect;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (Math.abs(before - this.camera.aspect) > 0.2) this.fit();
    this.dirty = true;
  }

  retheme() {
    this.scene.background = new Color(theme('sky'));
    if (this.grid) this.scene.remove(this.grid.helper);
    const normal = this.planar ? this.normal : this.up;
    const low = this.planar ? -0.04 * this.size + this.box.min.dot(normal) : this.box.min.dot(normal) - 0.03 * this.size;
    this.grid = grid(this.box, normal, low, new Color(theme('grid')));
    this.scene.add(this.grid.helper);
    this.dirty = true;
  }
}
