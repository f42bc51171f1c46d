// The picture with its controls: play, time, deformation, colours.

import { el } from './dom.js';
import { readable } from './clock.js';
import { css } from './colors.js';
import { FixedLoads } from './fixed.js';
import { inOneUnit, quantity, number } from './format.js';
import { View } from './view.js';

const kWholeMotion = 8;  // seconds that the whole motion takes to play
const kSpeeds = [0.1, 0.25, 0.5, 1, 2, 4];
const kScales = [1, 1e4], kAmplitudes = [0.1, 10];  // least and largest, of deformations and of modes

export class Player {
  /** @param summary names the load cases, and what acts in them, where the records are such */
  constructor(motion, clock, summary) {
    Object.assign(this, { motion, clock, summary, cases: summary.load_cases, playing: false, speed: 1, phase: 0, frames: [] });
    this.modes = motion.abscissa === 'frequency';
    this.shapes = this.modes || motion.abscissa === 'load_case';
    this.larger = this.modes ? 'amplitude' : motion.abscissa === 'time' ? 'deformation' : 'displacement';
    this.scales = this.modes ? kAmplitudes : kScales;
    this.instantText = motion.unit === 's' ? inOneUnit([clock.last], 's') : (at) => (motion.unit === '-' ? number(at, 4) : quantity(at, motion.unit, 4));
    this.canvas = el('canvas', { tabindex: 0, 'aria-label': 'mechanism; drag to turn, wheel to zoom' });
    this.stage = el('div', { class: 'stage' }, this.canvas);
    this.bar = el('div', { class: 'colours' });
    this.marks = el('div', { class: 'legend' });
    this.caption = el('p', { class: 'printed note' });  // on paper there are no sliders to read
    this.node = el('section', { class: 'card viewer' }, this.stage, this.bar, this.marks, this.caption, this.controls());
    this.hint();
  }

  /** Once the node is on the page, so that it has a size. */
  start() {
    try {
      this.view = new View(this.canvas, this.motion);
    } catch (error) {
      this.stage.replaceChildren(el('p', { class: 'note' }, 'No picture in space: this browser has no WebGL here.'));
      return;
    }
    this.canvas.openings = () => this.view.openings();
    this.fillColours();
    this.setScale(this.modes ? 1 : this.view.goodScale());
    if (this.summary.fixed_loads && this.view.parts.some((p) => p.view.sizes)) this.fixed = new FixedLoads(this.view, this.summary);
    if (!(this.view.deformed > 0)) for (const node of [this.scaler, this.node.querySelector('#good')]) node.disabled = true;  // rigid bodies only
    this.clock.listen(() => this.show());
    this.clock.listen(readable(() => this.tell()));
    if (!this.modes) this.clock.set(this.clock.t[this.motion.opens ?? this.view.largest]);
    if (this.modes) this.toggle(true);
    addEventListener('beforeprint', () => {
      this.describe();
      this.view.draw();
    });
    const loop = (now) => {
      this.advance(now);
      if (this.view.draw()) this.count(now);
      requestAnimationFrame(loop);
    };
    requestAnimationFrame(loop);
  }

  controls() {
    const { clock } = this, range = (id, attributes) => el('input', { type: 'range', id, ...attributes });
    this.button = el('button', { class: 'play', id: 'play', title: 'play or stop (space)', onclick: () => this.toggle() }, '\u25b6');
    this.slider = range('time', { min: 0, max: this.shapes ? clock.t.length - 1 : 1, step: this.shapes ? 1 : 'any', value: 0,
      disabled: this.shapes && clock.t.length < 2,
      oninput: () => this.seek(Number(this.slider.value)) });
    this.label = el('output', { for: 'time', id: 'instant' });
    this.scaler = range('scale', { min: Math.log10(this.scales[0]), max: Math.log10(this.scales[1]), step: 0.01, value: 0,
      oninput: () => this.setScale(roundScale(10 ** Number(this.scaler.value))) });
    this.scaleLabel = el('output', { for: 'scale' });
    this.colours = el('select', { id: 'colour', onchange: () => this.setColour(this.colours.value) });
    this.rate = el('select', { id: 'speed', title: 'speed', onchange: () => (this.speed = Number(this.rate.value)) },
      kSpeeds.map((s) => el('option', { value: s, selected: s === 1 }, `\u00d7 ${s}`)));
    return el('div', { class: 'controls' },
      this.button, el('label', { for: 'time' }, this.modes ? 'mode' : this.motion.abscissa.replace('_', ' ')), this.slider, this.label,
      el('span', {}), el('label', { for: 'scale' }, this.larger), this.scaler, this.scaleLabel,
      el('span', {}), el('label', { for: 'colour' }, 'colour'),
      el('span', { class: 'small' }, this.colours, this.rate,
        el('button', { id: 'good', title: `true shape, or ${this.larger} that can be seen (D)`, onclick: () => this.goodScale() }, this.modes ? 'as computed' : 'true / magnified'),
        el('button', { id: 'fit', title: 'whole motion (F)', onclick: () => this.view?.fit() }, 'fit')));
  }

  hint() {
    const { records, t } = this.motion, shown = t.n;
    if (this.shapes) return;
    const text = shown < records ? `${shown} of ${records} recorded instants, evenly spread; charts keep every peak` : `${records} instants`;
    this.node.append(el('p', { class: 'hint' }, text,
      ' \u00b7 space plays, \u2190 \u2192 steps, + \u2212 ', this.larger, ', C colour, F fits; on a chart P goes to its peak'));
  }

  fillColours() {
    this.colours.append(el('option', { value: '' }, 'bodies'));
    for (const q of this.view.quantities) this.colours.append(el('option', { value: q.key }, q.label));
    const first = this.view.quantities.find((q) => q.key === 'stress') ?? this.view.quantities[0];
    this.setColour(first?.key ?? '');
  }

  setColour(key) {
    const q = this.view.quantities.find((x) => x.key === key) ?? null;
    this.colours.value = key;
    this.view.set({ colour: q });
    this.bar.replaceChildren();
    if (!q) return;
    const stops = [0, 0.25, 0.5, 0.75, 1].map((s) => css(q.map, s)).join(',');
    const strip = el('span', { class: 'strip' });
    strip.style.background = `linear-gradient(to right, ${stops})`;
    this.bar.append(el('span', {}, q.label), el('span', {}, quantity(q.low, q.unit, 3)), strip, el('span', {}, quantity(q.high, q.unit, 3)));
  }

  nextColour() {
    const keys = [...this.colours.options].map((o) => o.value);
    this.setColour(keys[(keys.indexOf(this.colours.value) + 1) % keys.length]);
  }

  setScale(scale) {
    this.scale = Math.max(this.scales[0], Math.min(this.scales[1], scale));
    this.scaler.value = Math.log10(this.scale);
    this.scaleLabel.textContent = `\u00d7 ${number(this.scale, 3)}`;
    this.view?.set({ scale: this.scale });
  }
  goodScale() {
    this.setScale(this.modes ? 1 : this.scale > 1 ? 1 : this.view.goodScale());
  }

  seek(share) {
    const { clock } = this;
    if (this.shapes) return clock.set(clock.t[share]);
    clock.set(clock.first + share * (clock.last - clock.first));
  }

  show() {
    const { clock } = this;
    const record = Math.round(clock.record());
    this.view.set({ instant: this.shapes ? record : clock.record() });
    const share = (clock.at - clock.first) / (clock.last - clock.first || 1);
    this.slider.value = this.shapes ? record : share;
  }

  tell() {
    const { clock } = this, record = Math.round(clock.record());
    if (this.fixed) this.marks.replaceChildren(...this.fixed.legend());
    this.label.textContent = this.cases?.[record] ?? (this.modes ? `${record + 1}: ` : '') + this.instantText(clock.at);
  }

  /** What the sliders say, as a line. */
  describe() {
    const what = this.modes ? 'mode of' : this.motion.abscissa.replace('_', ' ');
    this.caption.textContent = `${what} ${this.label.textContent} \u00b7 ${this.larger} ${this.scaleLabel.textContent}`;
  }

  toggle(on = !this.playing) {
    this.playing = on;
    this.view?.plays(on);
    this.before = null;
    this.frames = [];
    this.button.textContent = on ? '\u275a\u275a' : '\u25b6';
    if (on && !this.shapes && this.clock.at >= this.clock.last) this.clock.set(this.clock.first);
    if (!on && this.shapes && !this.modes) this.view.set({ phase: 1 });
    if (!on) this.clock.set(this.clock.at);  // figures are those of where it stopped
  }

  advance(now) {
    if (!this.playing) return;
    const passed = this.before === null ? 0 : Math.min(now - this.before, 200) / 1000;
    this.before = now;
    if (this.modes) {
      this.phase += 2 * Math.PI * 0.5 * passed * this.speed;
      return this.view.set({ phase: Math.sin(this.phase) });
    }
    if (this.shapes) {  // the load comes and goes
      this.phase += 2 * Math.PI * 0.4 * passed * this.speed;
      return this.view.set({ phase: 0.5 * (1 - Math.cos(this.phase)) });
    }
    const { clock } = this, whole = clock.last - clock.first;
    let at = clock.at + (whole / kWholeMotion) * passed * this.speed;
    if (at > clock.last) at = clock.first;
    clock.set(at, true);
  }

  /** Pictures a second, over the last ones; for whoever measures: `data-fps`. */
  count(now) {
    this.frames.push(now);
    if (this.frames.length > 60) this.frames.shift();
    if (this.frames.length > 10)
      this.canvas.dataset.fps = ((1000 * (this.frames.length - 1)) / (now - this.frames[0])).toFixed(1);
    this.canvas.dataset.drawn = Number(this.canvas.dataset.drawn ?? 0) + 1;
  }

  key(event) {
    const act = {
      ' ': () => this.toggle(), ArrowLeft: () => this.clock.step(-1), ArrowRight: () => this.clock.step(1),
      '+': () => this.setScale(roundScale(this.scale * 1.5)), '-': () => this.setScale(roundScale(this.scale / 1.5)),
      f: () => this.view.fit(), c: () => this.nextColour(), d: () => this.goodScale(),
    }[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!act || !this.view) return false;
    act();
    return true;
  }
}

/** Two digits: what a slider says is what is shown. */
function roundScale(x) {
  const power = 10 ** (Math.floor(Math.log10(x)) - 1);
  return Math.round(x / power) * power;
}
