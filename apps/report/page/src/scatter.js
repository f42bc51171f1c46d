// Points of two columns, coloured by a third; hover or arrows tell the row, click or Enter opens it.

import { el, onTheme, theme } from './dom.js';
import { kSeries, css } from './colors.js';
import { ticks } from './charts.js';

const kLeft = 68, kBottom = 40, kTop = 12, kRight = 14, kHoverRadius = 9;

export class Scatter {
  /** @param describe row -> lines of text for the tip */
  constructor({ describe, open }) {
    Object.assign(this, { describe, open, points: [], hovered: null });
    this.canvas = el('canvas', { class: 'scatter', tabindex: 0, role: 'img', 'aria-label': 'points; arrows go from one to the next, Enter opens it' });
    this.tip = el('div', { class: 'tip', hidden: true, 'aria-live': 'polite' });
    this.node = el('div', { class: 'plot scatterbox' }, this.canvas, this.tip);
    this.canvas.addEventListener('mousemove', (e) => this.hover(e));
    this.canvas.addEventListener('mouseleave', () => this.hover(null));
    this.canvas.addEventListener('click', () => this.hovered && this.open?.(this.hovered.row));
    this.canvas.addEventListener('keydown', (e) => this.byKey(e));
    this.canvas.addEventListener('blur', () => this.point(null));
    new ResizeObserver(() => this.draw()).observe(this.node);
    onTheme(() => this.draw());
    addEventListener('beforeprint', () => this.draw());
  }

  /** @param points [{x, y, row, group, hollow}]  @param o {xlabel, ylabel, logx, logy, groups, lines, shade} */
  set(points, o) {
    this.o = o;
    this.points = points.filter((p) => Number.isFinite(p.x) && Number.isFinite(p.y) && (!o.logx || p.x > 0) && (!o.logy || p.y > 0));
    this.hovered = null;
    this.tip.hidden = true;
    this.draw();
  }

  draw() {
    const { canvas, node, o } = this;
    if (!o || !node.clientWidth) return;
    const ratio = devicePixelRatio || 1, w = node.clientWidth, h = 340;
    canvas.width = w * ratio;
    canvas.height = h * ratio;
    canvas.style.width = `${w}px`;
    canvas.style.height = `${h}px`;
    const ctx = (this.ctx = canvas.getContext('2d'));
    ctx.scale(ratio, ratio);
    ctx.font = '11px system-ui, sans-serif';
    this.ax = axisOf(this.points.map((p) => p.x), o.logx, kLeft, w - kRight);
    this.ay = axisOf(this.points.map((p) => p.y), o.logy, h - kBottom, kTop);
    this.drawAxes(ctx, w, h);
    if (o.lines) this.drawLines(ctx);
    for (const p of this.points) this.drawPoint(ctx, p, p === this.hovered ? 7 : 4.5);
  }

  drawAxes(ctx, w, h) {
    const { ax, ay, o } = this;
    ctx.strokeStyle = theme('line');
    ctx.fillStyle = theme('soft');
    ctx.textAlign = 'center';
    ctx.beginPath();
    let free = -Infinity;  // where the next label may begin
    const across = ticks(ax.ticks), upwards = ticks(ay.ticks);
    for (const [i, t] of ax.ticks.entries()) {
      ctx.moveTo(ax.at(t), kTop);
      ctx.lineTo(ax.at(t), h - kBottom);
      const half = 0.5 * ctx.measureText(across[i]).width;
      if (ax.at(t) - half < free) continue;
      ctx.fillText(across[i], Math.min(ax.at(t), w - half - 1), h - kBottom + 15);
      free = ax.at(t) + half + 8;
    }
    ctx.textAlign = 'right';
    for (const [i, t] of ay.ticks.entries()) {
      ctx.moveTo(kLeft, ay.at(t));
      ctx.lineTo(w - kRight, ay.at(t));
      ctx.fillText(upwards[i], kLeft - 7, ay.at(t) + 4);
    }
    ctx.stroke();
    ctx.textAlign = 'center';
    ctx.fillText(o.xlabel, (kLeft + w - kRight) / 2, h - 6);
    ctx.save();
    ctx.translate(12, (h - kBottom + kTop) / 2);
    ctx.rotate(-Math.PI / 2);
    ctx.fillText(o.ylabel, 0, 0);
    ctx.restore();
  }

  colour(p) {
    const { o } = this;
    if (o.shade) return css('size', p.shade ?? 0);
    return kSeries[Math.max(0, (o.groups ?? []).indexOf(p.group)) % kSeries.length];
  }

  drawPoint(ctx, p, r) {
    ctx.beginPath();
    ctx.arc(this.ax.at(p.x), this.ay.at(p.y), r, 0, 2 * Math.PI);
    ctx.fillStyle = p.hollow ? theme('card') : this.colour(p);
    ctx.globalAlpha = p === this.hovered ? 1 : 0.82;
    ctx.fill();
    ctx.globalAlpha = 1;
    ctx.strokeStyle = p.hollow ? this.colour(p) : theme('card');
    ctx.stroke();
  }

  /** The lower left border of each group: no point of it is better in both. */
  drawLines(ctx) {
    for (const group of this.o.groups) {
      const all = this.points.filter((p) => p.group === group && !p.hollow).sort((a, b) => a.x - b.x || a.y - b.y);
      const border = [];
      for (const p of all) if (!border.length || p.y < border[border.length - 1].y) border.push(p);
      if (border.length < 2) continue;
      ctx.beginPath();
      for (const p of border) ctx.lineTo(this.ax.at(p.x), this.ay.at(p.y));
      ctx.strokeStyle = this.colour(border[0]);
      ctx.globalAlpha = 0.5;
      ctx.lineWidth = 1.5;
      ctx.stroke();
      ctx.lineWidth = 1;
      ctx.globalAlpha = 1;
    }
  }

  hover(event) {
    let best = null, nearest = kHoverRadius;
    if (event && this.ax)
      for (const p of this.points) {
        const away = Math.hypot(this.ax.at(p.x) - event.offsetX, this.ay.at(p.y) - event.offsetY);
        if (away < nearest) [best, nearest] = [p, away];
      }
    this.point(best, event ?? {});
  }

  /** Tells a point, beside a place or where it is drawn; null: none. */
  point(best, { offsetX = best && this.ax.at(best.x), offsetY = best && this.ay.at(best.y) } = {}) {
    if (best !== this.hovered) {
      this.hovered = best;
      this.draw();
    }
    this.tip.hidden = !best;
    this.canvas.style.cursor = best && this.open ? 'pointer' : 'default';
    if (!best) return;
    this.tip.replaceChildren(...this.describe(best.row).map((line, i) => el(i ? 'div' : 'b', {}, line)));
    const right = offsetX > this.node.clientWidth / 2;
    this.tip.style.left = right ? 'auto' : `${offsetX + 14}px`;
    this.tip.style.right = right ? `${this.node.clientWidth - offsetX + 14}px` : 'auto';
    this.tip.style.top = `${Math.min(offsetY, 200)}px`;
  }

  /** Left and right in the order of x, up and down in that of y; Home and End: the first and the last of x. */
  byKey(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || !this.points.length) return;
    const { hovered } = this, by = (a, b) => [...this.points].sort((p, q) => p[a] - q[a] || p[b] - q[b]);
    const next = (list, way) => (hovered ? list[Math.max(0, Math.min(list.length - 1, list.indexOf(hovered) + way))] : list[0]);
    const act = {
      ArrowLeft: () => this.point(next(by('x', 'y'), -1)), ArrowRight: () => this.point(next(by('x', 'y'), 1)),
      ArrowDown: () => this.point(next(by('y', 'x'), -1)), ArrowUp: () => this.point(next(by('y', 'x'), 1)),
      Home: () => this.point(by('x', 'y')[0]), End: () => this.point(by('x', 'y')[this.points.length - 1]),
      Enter: () => hovered && this.open?.(hovered.row), Escape: () => this.point(null),
    }[event.key];
    if (!act) return;
    act();
    event.preventDefault();
    event.stopPropagation();
  }
}

/** {at, ticks} of an axis from pixel `from` to `to`. */
function axisOf(values, log, from, to) {
  let low = Math.min(...values), high = Math.max(...values);
  if (!values.length) [low, high] = [log ? 1 : 0, log ? 10 : 1];
  if (log) {
    const a = Math.log10(low), b = Math.log10(high), pad = 0.06 * (b - a || 1), ticks = [];
    const of = b - a > 2.2 ? [1] : b - a > 0.8 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9];
    for (let e = Math.floor(a - pad); e <= Math.ceil(b + pad); ++e)
      for (const m of of) if (Math.log10(m) + e >= a - pad && Math.log10(m) + e <= b + pad) ticks.push(m * 10 ** e);
    return { ticks, at: (x) => from + ((Math.log10(x) - a + pad) / (b - a + 2 * pad)) * (to - from) };
  }
  const pad = 0.06 * (high - low || Math.abs(high) || 1), a = low - pad, b = high + pad;
  return { ticks: linearTicks(a, b), at: (x) => from + ((x - a) / (b - a)) * (to - from) };
}

/** About six round values from a to b. */
export function linearTicks(a, b) {
  const raw = (b - a) / 6 || 1, power = 10 ** Math.floor(Math.log10(raw)), step = [1, 2, 5, 10].map((k) => k * power).find((k) => k >= raw);
  const ticks = [];
  for (let t = Math.ceil(a / step - 1e-9); t * step <= b + 1e-9 * step; ++t) ticks.push(t * step);
  return ticks;
}
