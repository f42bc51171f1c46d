// A map over two design variables: filled contours, the limit, the local model, the designs of an
// optimisation; the pointer tells the values.

import { card, el, onTheme, theme } from './dom.js';
import { kSeries, paint } from './colors.js';
import { linearTicks } from './scatter.js';
import { percent, quantity, scaleOf, tick } from './format.js';
import { swatch } from './charts.js';

const kLeft = 66, kBottom = 42, kTop = 12, kRight = 14, kHeight = 420, kBands = 12, kFine = 2;

export function maps(data) {
  return data.map ? new DesignMap(data).card() : null;
}

class DesignMap {
  constructor(data) {
    const s = data.summary, columns = data.map.columns;
    this.names = Object.keys(s.over);
    this.units = this.names.map((n) => s.over[n].unit);
    this.of = s.of;
    this.column = (name) => columns.find((c) => c.name === name);
    const at = this.names.map((n) => this.column(n).cells);
    this.nx = s.over[this.names[0]].points;
    this.x = at[0].slice(0, this.nx);
    this.y = at[1].filter((_, k) => k % this.nx === 0);
    this.reasons = this.column('reason')?.cells ?? [];
    this.path = data.path ? data.path.columns[1].cells.map((x, k) => [x, data.path.columns[2].cells[k]]) : [];
    this.centre = this.names.map((n) => s.centre[n]);
  }

  card() {
    const quantities = Object.keys(this.of);
    this.choice = el('select', { id: 'map-of', onchange: () => this.draw() }, quantities.map((n) => el('option', { value: n }, n)));
    this.local = el('input', { type: 'checkbox', id: 'map-local', checked: true, onchange: () => this.draw() });
    this.canvas = el('canvas', { class: 'scatter map', tabindex: 0, role: 'img', 'aria-label': 'contours over two variables; arrows move a pointer that tells the values' });
    this.tip = el('div', { class: 'tip', hidden: true, 'aria-live': 'polite' });
    this.plot = el('div', { class: 'plot mapbox' }, this.canvas, this.tip);
    this.key = el('span', { class: 'colours inline' });
    this.legend = el('div', { class: 'legend' });
    this.canvas.addEventListener('mousemove', (e) => this.hover(e));
    for (const leave of ['mouseleave', 'blur']) this.canvas.addEventListener(leave, () => this.hover(null));
    this.canvas.addEventListener('keydown', (e) => this.byKey(e));
    new ResizeObserver(() => this.draw()).observe(this.plot);
    onTheme(() => this.draw());
    const modelled = quantities.some((n) => this.column(`${n} local`));
    return card('Map', el('div', { class: 'controls row' }, el('label', { for: 'map-of' }, 'quantity'), this.choice,
      modelled ? el('span', { class: 'named' }, this.local, ' ', el('label', { for: 'map-local' }, 'local model')) : null, this.key), this.legend, this.plot,
    el('p', { class: 'note' }, 'Colours: the study itself, simulated at each point of the grid, linear between them.' +
      (modelled ? ' Dashed: the problem from which a cycle would take its next design, made at the star.' : '')));
  }

  values(name) { return this.column(name)?.cells ?? null; }

  draw() {
    const { canvas, plot } = this, w = plot.clientWidth;
    if (!w) return;
    const ratio = devicePixelRatio || 1, name = this.choice.value;
    Object.assign(canvas, { width: w * ratio, height: kHeight * ratio });
    canvas.style.width = `${w}px`;
    canvas.style.height = `${kHeight}px`;
    const ctx = canvas.getContext('2d');
    ctx.scale(ratio, ratio);
    ctx.font = '11px system-ui, sans-serif';
    this.ax = axisOf(this.x, kLeft, w - kRight);
    this.ay = axisOf(this.y, kHeight - kBottom, kTop);
    const values = this.values(name), known = values.filter((v) => v !== null);
    const low = Math.min(...known), high = Math.max(...known), { unit, limit } = this.of[name];
    this.levels = known.length && high > low ? [...Array(kBands - 1)].map((_, k) => low + ((k + 1) * (high - low)) / kBands) : [];
    this.fill(ctx, values, low, high);
    for (const level of this.levels) this.contour(ctx, values, level, theme('ink'), 0.5, []);
    const local = this.local.checked ? this.values(`${name} local`) : null;
    if (local) for (const level of this.levels) this.contour(ctx, local, level, kSeries[1], 1.1, [5, 4]);
    if (limit !== null) {
      this.contour(ctx, values, limit, theme('bad'), 2.6, []);
      if (local) this.contour(ctx, local, limit, theme('bad'), 2.2, [6, 4]);
    }
    this.drawAxes(ctx, w);
    this.drawDesigns(ctx);
    this.describe(low, high, unit, limit, !!local);
  }

  /** Bands of colour between the levels, at every second pixel. */
  fill(ctx, values, low, high) {
    const x0 = this.ax.at(this.x[0]), x1 = this.ax.at(this.x[this.nx - 1]), y0 = this.ay.at(this.y[0]), y1 = this.ay.at(this.y[this.y.length - 1]);
    const w = Math.max(1, Math.round((x1 - x0) / kFine)), h = Math.max(1, Math.round((y0 - y1) / kFine));
    const small = el('canvas', { width: w, height: h }), image = new ImageData(w, h), rgb = [0, 0, 0];
    for (let q = 0; q < h; ++q)
      for (let p = 0; p < w; ++p) {
        const v = this.valueAt(values, this.ax.from(x0 + ((p + 0.5) / w) * (x1 - x0)), this.ay.from(y1 + ((q + 0.5) / h) * (y0 - y1)));
        if (v === null) continue;
        const band = high > low ? Math.min(kBands - 1, Math.floor((kBands * (v - low)) / (high - low))) : 0, at = 4 * (q * w + p);
        paint('size', (band + 0.5) / kBands, rgb, 0);
        for (let c = 0; c < 3; ++c) image.data[at + c] = 255 * rgb[c];
        image.data[at + 3] = 255;
      }
    small.getContext('2d').putImageData(image, 0, 0);
    ctx.imageSmoothingEnabled = false;
    ctx.drawImage(small, x0, y1, x1 - x0, y0 - y1);
  }

  /** Bilinear between the points; null where one of them has no value. */
  valueAt(values, x, y) {
    const { nx } = this, [i, s] = cellOf(this.x, x), [j, t] = cellOf(this.y, y);
    const [a, b, c, d] = [values[j * nx + i], values[j * nx + i + 1], values[(j + 1) * nx + i], values[(j + 1) * nx + i + 1]];
    if ([a, b, c, d].some((v) => v === null || v === undefined)) return null;
    return (1 - t) * ((1 - s) * a + s * b) + t * ((1 - s) * c + s * d);
  }

  /** Marching squares over the grid. */
  contour(ctx, values, level, colour, width, dash) {
    const { nx, x, y, ax, ay } = this;
    ctx.beginPath();
    for (let j = 0; j + 1 < y.length; ++j)
      for (let i = 0; i + 1 < nx; ++i) {
        const corner = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
        const v = corner.map(([p, q]) => values[q * nx + p]);
        if (v.some((u) => u === null)) continue;
        const cuts = [];
        for (let k = 0; k < 4; ++k) {
          const a = v[k], b = v[(k + 1) % 4];
          if (a < level === b < level) continue;
          const s = (level - a) / (b - a), [p, q] = corner[k], [P, Q] = corner[(k + 1) % 4];
          cuts.push([ax.at(x[p] + s * (x[P] - x[p])), ay.at(y[q] + s * (y[Q] - y[q]))]);
        }
        for (let k = 0; k + 1 < cuts.length; k += 2) {
          ctx.moveTo(...cuts[k]);
          ctx.lineTo(...cuts[k + 1]);
        }
      }
    ctx.strokeStyle = colour;
    ctx.lineWidth = width;
    ctx.setLineDash(dash);
    ctx.stroke();
    ctx.setLineDash([]);
    ctx.lineWidth = 1;
  }

  drawAxes(ctx, w) {
    const { ax, ay } = this, label = (k) => {
      const scale = scaleOf(Math.max(...(k ? this.y : this.x).map(Math.abs)), this.units[k]);
      return { scale, text: `${this.names[k]}${scale.unit && scale.unit !== '-' ? ` [${scale.unit}]` : ''}` };
    };
    const lx = label(0), ly = label(1);
    ctx.fillStyle = theme('soft');
    ctx.strokeStyle = theme('line');
    ctx.strokeRect(kLeft, kTop, w - kRight - kLeft, kHeight - kBottom - kTop);
    ctx.textAlign = 'center';
    for (const t of ax.ticks) ctx.fillText(tick(t / lx.scale.factor, 3), ax.at(t), kHeight - kBottom + 15);
    ctx.fillText(lx.text, (kLeft + w - kRight) / 2, kHeight - 6);
    ctx.textAlign = 'right';
    for (const t of ay.ticks) ctx.fillText(tick(t / ly.scale.factor, 3), kLeft - 7, ay.at(t) + 4);
    ctx.save();
    ctx.translate(12, (kHeight - kBottom + kTop) / 2);
    ctx.rotate(-Math.PI / 2);
    ctx.textAlign = 'center';
    ctx.fillText(ly.text, 0, 0);
    ctx.restore();
  }

  /** Designs of an optimisation, numbered, and a star where the local model is made. */
  drawDesigns(ctx) {
    const { ax, ay } = this;
    ctx.strokeStyle = ctx.fillStyle = '#fff';
    const places = this.path.map(([x, y]) => [ax.at(x), ay.at(y)]);
    for (const [width, colour] of [[4, 'rgb(0 0 0 / .55)'], [1.8, '#fff']]) {
      ctx.beginPath();
      for (const p of places) ctx.lineTo(...p);
      ctx.lineWidth = width;
      ctx.strokeStyle = colour;
      ctx.stroke();
    }
    ctx.lineWidth = 1;
    ctx.strokeStyle = '#000';
    for (const [px, py] of places) {
      ctx.beginPath();
      ctx.arc(px, py, 3.6, 0, 2 * Math.PI);
      ctx.fillStyle = '#fff';
      ctx.fill();
      ctx.stroke();
    }
    const [cx, cy] = [ax.at(this.centre[0]), ay.at(this.centre[1])];
    ctx.beginPath();
    for (let k = 0; k < 10; ++k) ctx.lineTo(cx + (k % 2 ? 3.5 : 9) * Math.sin((k * Math.PI) / 5), cy - (k % 2 ? 3.5 : 9) * Math.cos((k * Math.PI) / 5));
    ctx.closePath();
    ctx.fillStyle = kSeries[1];
    ctx.fill();
    ctx.stroke();
  }

  describe(low, high, unit, limit, local) {
    const strip = el('span', { class: 'strip viridis' });
    this.key.replaceChildren(el('span', {}, Number.isFinite(low) ? quantity(low, unit, 3) : 'no value', ' ', strip, ' ', Number.isFinite(high) ? quantity(high, unit, 3) : ''));
    const item = (colour, dashed, text) => el('span', {}, swatch(colour, dashed), text);
    this.legend.replaceChildren(...[limit !== null ? item('var(--bad)', false, `limit ${quantity(limit, unit)}`) : null, local ? item(kSeries[1], true, 'local model') : null,
      this.path.length ? el('span', {}, '\u25cb designs of the optimisation') : null, el('span', {}, '\u2605 centre')].filter(Boolean));
  }

  /** Arrows move the pointer by a step of 40, from the centre. */
  byKey(event) {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!way || !this.ax || event.ctrlKey || event.metaKey || event.altKey) return;
    this.pointed = [this.x, this.y].map((places, k) => {
      const low = places[0], span = places[places.length - 1] - low, now = (this.pointed ?? this.centre)[k];
      return low + span * Math.max(1e-6, Math.min(1 - 1e-6, (now - low) / span + way[k] / 40));
    });
    this.hover({ offsetX: this.ax.at(this.pointed[0]), offsetY: this.ay.at(this.pointed[1]) });
    event.preventDefault();
    event.stopPropagation();
  }

  /** All quantities under the pointer; null: it has left. */
  hover(event) {
    const { ax, ay, names, units, tip } = this;
    if (!event) tip.hidden = true;
    if (!ax || !event) return;
    const x = ax.from(event.offsetX), y = ay.from(event.offsetY);
    const inside = x >= this.x[0] && x <= this.x[this.nx - 1] && y >= this.y[0] && y <= this.y[this.y.length - 1];
    tip.hidden = !inside;
    if (!inside) return;
    const lines = [`${names[0]} ${quantity(x, units[0])}, ${names[1]} ${quantity(y, units[1])}`];
    for (const [name, { unit, limit }] of Object.entries(this.of)) {
      const v = this.valueAt(this.values(name), x, y), cells = this.values(`${name} local`), m = cells ? this.valueAt(cells, x, y) : null;
      lines.push(`${name}: ${v === null ? '\u2013' : quantity(v, unit)}${v !== null && limit ? `, ${percent(v / limit - 1)} above the limit` : ''}` + (m === null ? '' : `; local ${quantity(m, unit)}`));
    }
    const [i, s] = cellOf(this.x, x), [j, t] = cellOf(this.y, y), reason = this.reasons[(j + Math.round(t)) * this.nx + i + Math.round(s)];
    if (reason) lines.push(reason);
    tip.replaceChildren(...lines.map((line, k) => el(k ? 'div' : 'b', {}, line)));
    const right = event.offsetX > this.plot.clientWidth / 2;
    tip.style.left = right ? 'auto' : `${event.offsetX + 14}px`;
    tip.style.right = right ? `${this.plot.clientWidth - event.offsetX + 14}px` : 'auto';
    tip.style.top = `${Math.min(event.offsetY, kHeight - 130)}px`;
  }
}

/** Which of growing places come before x, and how far on it is: [index, share]. */
function cellOf(places, x) {
  let i = 0;
  while (i + 2 < places.length && places[i + 1] <= x) ++i;
  return [i, Math.max(0, Math.min(1, (x - places[i]) / (places[i + 1] - places[i])))];
}

/** {at, from, ticks}: pixels of values and back. */
function axisOf(values, from, to) {
  const low = values[0], high = values[values.length - 1], span = high - low || 1;
  return { ticks: linearTicks(low, high), at: (x) => from + ((x - low) / span) * (to - from), from: (p) => low + ((p - from) / (to - from)) * span };
}
