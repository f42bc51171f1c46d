// Lines over time, with a cursor at the instant shown.

import uPlot from 'uplot';
import { array, valueAt } from './data.js';
import { Clock, readable } from './clock.js';
import { card, el, isDark, onTheme, theme } from './dom.js';
import { kSeries } from './colors.js';
import { number, percent, quantity, scaleOf, tick } from './format.js';

const kPlots = [];
onTheme(() => kPlots.forEach((p) => p.redraw(false)));
const kPrinted = 318;  // pixels of a chart on a sheet, two beside each other
addEventListener('beforeprint', () => kPlots.forEach((p) => p.setSize({ width: kPrinted, height: p.height })));
addEventListener('afterprint', () => kPlots.forEach((p) => p.setSize({ width: p.root.parentElement.clientWidth, height: p.height })));

const kHeight = 190;  // pixels
const kDashed = { initial: [5, 4], total: [5, 4] };  // so that what lies beneath is seen
const colourOf = (label, i) => (label === 'initial' ? kSeries[1] : label === 'final' ? kSeries[0] : kSeries[i % kSeries.length]);

const kRoundOff = 1e-12;  // of the peak of a line: less is told as 0
const kMostCharts = 8;  // at once: more are folded

/** Charts of what has more than two records, as cards; of many those nearest to their limit, and the rest folded. */
export function timeCharts(list, clock) {
  const charts = list.filter((d) => d.lines.some((l) => l.x.n > 2));
  if (charts.length <= kMostCharts) return charts.map((d) => timeChart(d, clock));
  const used = new Map(charts.map((d) => [d, d.limit ? peak(array(d.lines[d.lines.length - 1].y)) / d.limit : 0]));
  charts.sort((a, b) => used.get(b) - used.get(a));
  const shown = charts.slice(0, kMostCharts), rest = charts.slice(kMostCharts), body = el('div', { class: 'column' });
  const open = () => body.childNodes.length || body.append(...rest.map((d) => timeChart(d, clock)));
  const which = used.get(charts[0]) > 0 ? `, further from their limits` : '';
  return [...shown.map((d) => timeChart(d, clock)),
    el('details', { class: 'card folded', ontoggle: open }, el('summary', {}, `${rest.length} more charts${which}`), body)];
}

/** A chart of the page's data as a card. @param clock null: the chart has an instant of its own */
function timeChart(d, clock) {
  const all = d.lines.map((l) => ({ label: l.label, x: array(l.x), y: array(l.y) }));
  const moving = all.filter((l) => peak(l.y) > 0), lines = moving.length ? moving : all;
  const still = all.filter((l) => !lines.includes(l)).map((l) => l.label);
  let size = d.limit ?? 0;
  for (const l of lines) for (const y of l.y) size = Math.max(size, Math.abs(y));
  const scale = scaleOf(size, d.unit);
  const unit = scale.unit && scale.unit !== '-' ? `\u00a0${scale.unit}` : '';
  const legend = el('div', { class: 'legend' });
  const holder = el('div', { class: 'plot' });
  holder.style.minHeight = `${d.height ?? kHeight}px`;  // it is drawn later than the columns are measured
  const over = lines.map((l) => peak(l.y) / d.limit - 1);
  const head = el('h2', {}, d.title, el('span', { class: 'unit' }, scale.unit ? ` [${scale.unit}]` : ''));
  const box = el('section', { class: 'card chart', 'data-chart': d.title }, head, legend, holder);
  const values = lines.map((line, i) => {
    const value = el('b', {});
    const note = d.limit ? el('i', { class: over[i] > 1e-3 ? 'bad' : '' }, ` peak ${percent(over[i])}`) : null;
    legend.append(el('span', {}, swatch(colourOf(line.label, i), !!kDashed[line.label]), line.label, ' ', value, note));
    return value;
  });
  if (d.limit)
    legend.append(el('span', {}, swatch('var(--bad)', true), 'limit ', el('b', {}, tick(d.limit / scale.factor) + unit)));
  if (d.error)
    legend.append(el('span', { class: 'error' }, 'error of the peak by mesh and step ± ', el('b', {}, quantity(d.error, d.unit, 2))));
  if (still.length)
    legend.append(el('span', { class: 'still' }, `${still.join(', ')}: 0 throughout`));
  const plot = draw(holder, lines, d, scale);
  const least = lines.map((l) => kRoundOff * peak(l.y));
  const told = (value, i) => (Math.abs(value) < least[i] ? 0 : value);
  const tell = (t) => lines.forEach((l, i) => (values[i].textContent = number(told(valueAt(l.x, l.y, t), i) / scale.factor, 4) + unit));
  follow(plot, clock ?? new Clock(lines[0].x), tell, { name: d.title, peak: () => placeOfPeak(lines), words: () => legend.textContent });
  return box;
}

function peak(y) {
  let most = 0;
  for (const v of y) if (Number.isFinite(v)) most = Math.max(most, Math.abs(v));
  return most;
}

/** Where the last line, that of the final design, is largest. */
function placeOfPeak(lines) {
  const { x, y } = lines[lines.length - 1], most = peak(y);
  return x[Math.max(0, y.findIndex((v) => Math.abs(v) === most))];
}

export function swatch(colour, dashed = false) {
  const node = el('span', { class: dashed ? 'swatch dashed' : 'swatch' });
  node.style.background = dashed ? 'none' : colour;
  if (dashed) node.style.borderColor = colour;
  return node;
}

function axes(d) {
  const style = { stroke: () => theme('soft'), font: '11px system-ui, sans-serif', ticks: { show: false },
    grid: { stroke: () => theme('line'), width: 1 } };
  const label = d.abscissa_unit && d.abscissa_unit !== '-' ? `${d.abscissa} [${d.abscissa_unit}]` : d.abscissa;
  return [
    { ...style, size: 22, incrs: d.points ? [1, 2, 5, 10, 20, 50, 100] : undefined, label: label.replace('_', ' '), labelSize: 15, labelFont: '11px system-ui, sans-serif', labelGap: -2, values: (_, v) => ticks(v) },
    { ...style, size: 48, values: (_, v) => ticks(v) },
  ];
}

/** Labels of an axis, with as many digits as tell neighbours apart. */
export function ticks(values) {
  const step = Math.min(...values.slice(1).map((x, i) => x - values[i]));
  for (let digits = 3; digits < 8; ++digits) {
    const texts = values.map((x) => tick(x, digits));
    if (values.every((x) => Math.abs(Number(x.toPrecision(digits)) - x) < 0.05 * step)) return texts;
  }
  return values.map((x) => tick(x, 8));
}

function draw(holder, lines, d, scale) {
  const tables = lines.map((l) => [l.x, Array.from(l.y, (y) => (Number.isFinite(y) ? y / scale.factor : null))]);
  const data = tables.length > 1 ? uPlot.join(tables.map((t) => t.map((c) => Array.from(c)))) : tables[0];
  const plot = new uPlot({
    width: 400, height: d.height ?? kHeight, padding: [8, 16, 0, 0],
    legend: { show: false },
    cursor: { points: { size: 6 }, drag: { x: true, y: false }, y: false },
    scales: { x: { time: false }, y: { range: (_, low, high) => range(low, high, d.limit ? d.limit / scale.factor : null) } },
    axes: axes(d),
    series: [{}, ...lines.map((l, i) => ({
      stroke: colourOf(l.label, i), width: 1.6, spanGaps: true, dash: kDashed[l.label], points: { show: !!d.points, size: 6 },
    }))],
    hooks: { draw: [(u) => {
      lines.forEach((l, i) => drawBand(u, tables[i], l.label === 'initial' ? 0 : (d.error ?? 0) / scale.factor, colourOf(l.label, i)));
      drawLimit(u, d.limit ? d.limit / scale.factor : null);
    }] },
  }, data, holder);
  new ResizeObserver(() => {
    if (holder.clientWidth) plot.setSize({ width: holder.clientWidth, height: d.height ?? kHeight });
  }).observe(holder);
  kPlots.push(plot);
  return plot;
}

const kRounding = 1e-5;  // differences, of the values, that are no curve

function range(low, high, limit) {
  if (low === null || high === null) return [0, 1];
  const top = limit ? Math.max(high, 1.08 * limit) : high;
  const size = Math.max(Math.abs(low), Math.abs(top)), span = top - low > kRounding * size ? top - low : size;
  const pad = 0.06 * (span || 1);
  return [low >= 0 && low < 0.3 * top ? 0 : low - pad, top + pad];
}

/** The error of the largest value on either side of a line. */
function drawBand(u, [x, y], error, colour) {
  if (!(error > 0)) return;
  const { ctx, bbox } = u, n = x.length;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
  ctx.clip();
  ctx.beginPath();
  for (let k = 0; k < 2 * n; ++k) {
    const above = k < n, i = above ? k : 2 * n - 1 - k;
    ctx.lineTo(u.valToPos(x[i], 'x', true), u.valToPos(y[i] + (above ? error : -error), 'y', true));
  }
  ctx.globalAlpha = 0.22;
  ctx.fillStyle = colour;
  ctx.fill();
  ctx.restore();
}

/** A dashed line, and a shade where the limit is broken. */
function drawLimit(u, limit) {
  if (!limit) return;
  const { ctx, bbox } = u, y = u.valToPos(limit, 'y', true);
  ctx.save();
  ctx.fillStyle = isDark() ? 'rgba(255,90,80,.10)' : 'rgba(200,40,30,.07)';
  ctx.fillRect(bbox.left, bbox.top, bbox.width, Math.max(0, y - bbox.top));
  ctx.strokeStyle = theme('bad');
  ctx.setLineDash([6, 4]);
  ctx.beginPath();
  ctx.moveTo(bbox.left, y);
  ctx.lineTo(bbox.left + bbox.width, y);
  ctx.stroke();
  ctx.restore();
}

/**
 * A line at the clock's instant; a click goes there, and so do keys.
 * @param o {name, peak: where P goes, words: what is said of the instant}
 */
function follow(plot, clock, show, o) {
  const cursor = el('div', { class: 'now' }), { over } = plot;
  over.append(cursor);
  const place = (t) => {
    const x = plot.valToPos(t, 'x');
    cursor.style.transform = `translateX(${x.toFixed(1)}px)`;
    cursor.hidden = !(x >= 0 && x <= over.clientWidth);
  };
  const say = () => {
    over.setAttribute('aria-valuenow', clock.at);
    over.setAttribute('aria-valuetext', o.words());
  };
  for (const [name, value] of Object.entries({ tabindex: 0, role: 'slider', 'aria-label': o.name, 'aria-valuemin': clock.first, 'aria-valuemax': clock.last }))
    over.setAttribute(name, value);
  clock.listen(place);
  clock.listen(readable((t) => {
    show(t);
    if (document.activeElement === over) say();
  }));
  say();
  plot.hooks.setSize = [() => place(clock.at)];
  plot.hooks.setScale = [() => place(clock.at)];
  let down = 0;
  over.addEventListener('mousedown', (event) => (down = event.clientX));
  over.addEventListener('click', (event) => {
    if (Math.abs(event.clientX - down) > 3) return;
    clock.set(plot.posToVal(event.clientX - over.getBoundingClientRect().left, 'x'));
  });
  over.addEventListener('focus', say);
  over.addEventListener('keydown', (event) => byKey(event, clock, o.peak));
}

/** Arrows a record, pages a tenth of all, Home and End the ends, P the peak. */
function byKey(event, clock, toPeak) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const tenth = Math.max(1, Math.round(clock.t.length / 10));
  const act = {
    ArrowLeft: () => clock.step(-1), ArrowRight: () => clock.step(1), PageDown: () => clock.step(-tenth), PageUp: () => clock.step(tenth),
    Home: () => clock.set(clock.first), End: () => clock.set(clock.last), p: () => clock.set(toPeak()),
  }[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (!act) return;
  act();
  event.preventDefault();
  event.stopPropagation();  // else the picture would step, too
}

/** One figure over the cycles, with a mark at the chosen one. */
export function cycleChart(title, unit, cycles, values, choice) {
  const d = { title, unit, abscissa: choice.word, abscissa_unit: '', height: 130, points: true };
  const scale = scaleOf(peak(values), unit);
  const holder = el('div', { class: 'plot' });
  const line = { label: 'final', x: Float64Array.from(cycles), y: Float64Array.from(values) }, plot = draw(holder, [line], d, scale);
  const words = () => `${choice.word} ${choice.at}: ${number(valueAt(line.x, line.y, choice.at) / scale.factor, 4)} ${scale.unit}`;
  follow(plot, choice, () => {}, { name: title, peak: () => placeOfPeak([line]), words });
  return el('div', { class: 'chart' }, el('h3', {}, title, el('span', { class: 'unit' }, scale.unit ? ` [${scale.unit}]` : '')), holder);
}

export { card, quantity };
