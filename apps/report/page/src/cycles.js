// The cycles of an optimisation: a slider over the designs, what was simulated and what it gave.

import { array } from './data.js';
import { card, el, svg } from './dom.js';
import { cycleChart } from './charts.js';
import { Clock } from './clock.js';
import { loadCases } from './loadcases.js';
import { excess, isOwn, percent, quantity } from './format.js';

// Names of section dimensions by shape, in the order of results.h5.
const kDimensions = {
  circle: ['diameter'], tube: ['diameter', 'thickness'], rectangle: ['width', 'height'],
  box: ['width', 'height', 'thickness'], I: ['width', 'height', 'flange_thickness', 'web_thickness'],
};

export function cycles(data, player) {
  const s = data.summary, history = s.history ?? [];
  if (history.length < 1) return null;
  const numbers = history.map((h) => h.cycle);
  const choice = new Clock(Float64Array.from(numbers));
  choice.word = s.load_cases ? 'step' : 'cycle';
  const slider = el('input', { type: 'range', id: 'cycle', min: 0, max: history.length - 1, step: 1, value: history.length - 1,
    oninput: () => choice.set(numbers[Number(slider.value)]) });
  const label = el('output', { for: 'cycle' }), figures = el('dl', { class: 'figures' });
  const pictures = data.outlines.map((o) => outlinePicture(o));
  const bars = designBars(s, history);
  const loads = loadCases(data, player, data.motion?.unit);
  choice.listen(() => {
    const i = Math.round(choice.record()), h = history[i];
    slider.value = i;
    label.textContent = `${choice.word} ${h.cycle} of ${numbers[numbers.length - 1]}`;
    figures.replaceChildren(...figuresOf(h, data));
    loads?.show(h.cycle);
    bars?.show(h.design);
    for (const picture of pictures) picture.show(h.cycle, i === history.length - 1);
    showSections(data, player, h.design, i === history.length - 1);
  });
  const objective = history.every((h) => typeof h.objective === 'number');
  const first = objective
    ? cycleChart(s.objective?.quantity ?? 'objective', s.objective?.unit ?? '', numbers, history.map((h) => h.objective), choice)
    : cycleChart('mass', 'kg', numbers, history.map((h) => h.mass), choice);
  const own = Object.values(s.constraints ?? {}).some(isOwn);  // whose numbers are no shares
  const second = cycleChart(own ? 'worst limit, share or number above it' : 'worst limit, above it [%]', '', numbers,
    history.map((h) => (own ? 1 : 100) * h.worst_constraint), choice);
  const forces = loads && numbers.some((n) => loads.known(n))
    ? cycleChart('largest load', 'N', numbers, numbers.map((n) => (loads.known(n) ? loads.largest(n) : NaN)), choice) : null;
  const node = card(choice.word === 'step' ? 'Steps' : 'Cycles',
    el('div', { class: 'controls two' }, slider, label),
    el('div', { class: 'split' }, el('div', {}, first, second, forces), el('div', {}, figures, loads?.node, ...pictures.map((p) => p.node), bars?.node)));
  choice.set(numbers[numbers.length - 1]);
  return node;
}

/** " at t = 0.1 s", " at load factor 1"; of fixed loads " in load case 'lifting'". */
function place(text, data) {
  if (!text) return '';
  return data.summary.load_cases ? ` in load case '${text}'` : ` at ${text}`;
}

function figuresOf(h, data) {
  const s = data.summary, out = [], add = (name, value) => out.push(el('dt', {}, name), el('dd', {}, value));
  add('mass', `${quantity(h.mass, 'kg')} (${percent(h.mass / s.mass_initial - 1)})`);
  if (typeof h.objective === 'number') add(s.objective?.quantity ?? 'objective', quantity(h.objective, s.objective?.unit));
  const above = (name, value) => excess(value, isOwn(s.constraints?.[name]));
  add('worst limit', above(h.worst_limit, h.worst_constraint) + (h.worst_limit ? ` '${h.worst_limit}'${place(h.worst_at, data)}` : ''));
  for (const [name, limit] of Object.entries(h.limits ?? {}))
    if (name !== h.worst_limit) add(`limit '${name}'`, above(name, limit.violation) + place(limit.at, data));
  if (h.load_change !== undefined && !s.load_cases) add('change of the loads', h.load_change === null ? '\u2013' : percent(h.load_change).replace('+', ''));
  add('load cases kept', h.load_cases || '\u2013');
  add('iterations of the optimiser', h.optimizer_iterations || '\u2013');
  return out;
}

/** The design of a cycle as bars between the bounds. */
function designBars(s, history) {
  const names = Object.keys(s.design ?? {});
  if (!history.some((h) => h.design?.length === names.length) || names.length > 60) return null;
  const rows = names.map((name) => {
    const fill = el('i', {}), value = el('span', {});
    return { name, fill, value, node: el('div', { class: 'bar' }, el('span', {}, name), el('span', { class: 'track' }, fill), value) };
  });
  return {
    node: el('div', { class: 'bars' }, rows.map((r) => r.node)),
    show(x) {
      if (x?.length !== names.length) return;
      for (const [i, row] of rows.entries()) {
        const range = s.design_range[row.name];
        row.fill.style.width = `${(100 * (x[i] - range.lower)) / (range.upper - range.lower || 1)}%`;
        row.value.textContent = quantity(x[i], range.unit);
      }
    },
  };
}

/** Sections of that cycle in the picture in space; the motion stays that of the final design. */
function showSections(data, player, x, last) {
  const view = player?.view;
  if (!view || !data.sized.length || !x) return;
  const names = Object.keys(data.summary.design), values = new Map(names.map((n, i) => [n, x[i]]));
  for (const { view: beam, body } of view.parts) {
    const rows = data.sized.filter((r) => r.body === body.name);
    if (!rows.length || !beam.setSections) continue;
    const changed = new Map();
    for (const row of rows) {
      const d = changed.get(row.element) ?? body.dimensions.slice(4 * row.element, 4 * row.element + 4);
      for (const name of row.dimensions.split('+')) {
        const at = (kDimensions[body.shapes[row.element]] ?? []).indexOf(name);
        if (at >= 0 && values.get(row.variable) > 0) d[at] = values.get(row.variable);
      }
      changed.set(row.element, d);
    }
    beam.setSections(last ? null : changed);
  }
  view.set({});
}

/** Outline of a planar part over the designs; the start dashed; stress on the final one. */
function outlinePicture(o) {
  const steps = o.steps.map((st) => ({ step: st.step, lines: st.lines.map((l) => array(l)) }));
  const box = bounds(steps.flatMap((st) => st.lines));
  const path = svg('path', { class: 'material', 'fill-rule': 'evenodd' });
  const start = svg('path', { class: 'before', d: pathOf(steps[0].lines) });
  const margin = 0.03 * Math.max(box.w, box.h);
  const node = el('figure', { class: 'outline', 'data-part': o.part },
    svg('svg', { viewBox: `${box.x - margin} ${-box.y - box.h - margin} ${box.w + 2 * margin} ${box.h + 2 * margin}`, role: 'img' },
      svg('title', {}, `outline of ${o.part}`), path, start),
    el('figcaption', {}, `${o.part}: outline, that of the start dashed`));
  return {
    node,
    show(step) {
      let best = steps[0];
      for (const st of steps) if (Math.abs(st.step - step) < Math.abs(best.step - step)) best = st;
      path.setAttribute('d', pathOf(best.lines));
    },
  };
}

function pathOf(lines) {
  return lines.map((l) => {
    let d = '';
    for (let i = 0; i < l.length; i += 2) d += `${i ? 'L' : 'M'}${l[i].toPrecision(6)} ${(-l[i + 1]).toPrecision(6)}`;
    return d + 'Z';
  }).join('');
}

function bounds(lines) {
  let x = Infinity, y = Infinity, X = -Infinity, Y = -Infinity;
  for (const l of lines) for (let i = 0; i < l.length; i += 2) {
    x = Math.min(x, l[i]); X = Math.max(X, l[i]);
    y = Math.min(y, l[i + 1]); Y = Math.max(Y, l[i + 1]);
  }
  return { x, y, w: X - x || 1, h: Y - y || 1 };
}
