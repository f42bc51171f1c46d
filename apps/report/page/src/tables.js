// Figures of a summary as tables: head, limits, design, provenance.

import { breakable, card, el } from './dom.js';
import { leanTiles } from './lean.js';
import { excess, isOwn, number, percent, prose, quantities, quantity, share, tick, worstLimit } from './format.js';

const kGood = ['done', 'optimal', 'converged'];
const kMiddling = ['converged', 'recovered', 'running', 'incomplete', 'cycle limit', 'interrupted'];

/** `certified`: results that have a KKT residual, of which what converged need not be optimal. */
export function badge(status, certified = false) {
  const good = kGood.includes(status) && !(certified && status === 'converged');
  const kind = good ? 'good' : kMiddling.includes(status) ? 'fair' : 'poor';
  return el('span', { class: `badge ${kind}` }, status);
}

/** Has a case ended as it should? */
export const succeeded = (status) => kGood.includes(status);

/** What is optimised: a motion, or a part under fixed or growing loads. */
const subject = ({ motion, summary }) => (summary.load_cases || (motion && motion.abscissa !== 'time') ? 'study' : 'motion');

const kMeaning = {
  optimal: 'The optimality conditions of the motion hold, and all limits are met.',
  converged: 'Loads and design agree; whether the design is optimal for the motion, the residual below tells.',
  'cycle limit': 'As many cycles as allowed, without agreement; the best design so far is shown.',
  oscillating: 'The designs went to and fro; the best one is shown.',
  infeasible: 'Limits are exceeded, and no step from this design improves that; another start may.',
  inaccurate: 'The end was reached, but the time integration lost or made too much energy.',
};

function sentence(text) {
  if (!text) return text;
  const plain = prose(text), key = /^\w+[._]\w/.test(plain);  // "cycle.max = 3 is used up"
  const printed = key ? plain : plain[0].toUpperCase() + plain.slice(1);
  return /[.!?]$/.test(printed) ? printed : `${printed}.`;
}

export function tile(label, value, note, kind) {
  return el('div', { class: 'tile' }, el('span', {}, label), el('b', { class: kind ?? '' }, value), note ? el('small', {}, note) : null);
}

/** In all, or that of the mesh and that of the step, where they were verified. */
const both = (error) => (error ? error.total ?? (error.mesh ?? 0) + (error.step ?? 0) : undefined);
const errorOf = ({ error }) => both(error);
const plusMinus = (text) => `\u00b1\u00a0${text}`;

/** What the KKT residual says of the end. */
function optimality(data) {
  const { kkt_residual: residual, worst_constraint: worst } = data.summary;
  if (residual === null) return 'not checked';
  if (worst > 1e-3) return 'but limits are exceeded';
  return `${residual <= 0.01 ? 'optimal' : 'not optimal'} for the ${subject(data)}`;
}

/** "slider-crank, rod", of a batch's case "slider-crank, rod: case 3". */
export function titleOf({ summary, folder, batch }) {
  return (summary.name || folder) + (batch ? `: case ${folder}` : '');
}

/** Name, status, reason, and the figures that matter most. */
export function head(data) {
  const s = data.summary, reason = s.reason;
  const meaning = /optimality conditions of the/.test(reason) ? null : kMeaning[s.status];  // said by the reason
  const tiles = leanTiles(s);
  if (s.mass_initial !== undefined)
    tiles.push(tile('mass', `${quantity(s.mass_initial, 'kg')} \u2192 ${quantity(s.mass_final, 'kg')}`, percent(s.mass_final / s.mass_initial - 1)));
  if (s.objective && s.objective.quantity !== 'mass')
    tiles.push(tile(s.objective.quantity, `${quantity(s.objective.initial, s.objective.unit)} \u2192 ${quantity(s.objective.final, s.objective.unit)}`,
      percent(s.objective.final / s.objective.initial - 1)));
  if (s.worst_constraint !== undefined && s.worst_constraint !== null) {
    const known = s.worst_constraint_error === undefined ? '' : `, ${plusMinus(share(s.worst_constraint_error))} by mesh and step`;
    tiles.push(tile('worst limit', excess(s.worst_constraint, isOwn(worstLimit(s))), (s.worst_constraint > 1e-3 ? 'above it' : 'it is met') + known, s.worst_constraint > 1e-3 ? 'bad' : 'fine'));
  }
  if (s.cycles) tiles.push(tile('cycles', s.cycles, `in ${quantity(s.wall_s, 's', 3)}`));
  if (s.kkt_residual !== undefined)
    tiles.push(tile('KKT residual', s.kkt_residual === null ? '\u2013' : number(s.kkt_residual, 2), optimality(data)));
  if (s.frequencies_hz?.length) tiles.push(tile('lowest frequency', quantity(s.frequencies_hz[0], 'Hz', 4), `of ${s.frequencies_hz.length}`));
  else if (s.steps && s.cycles === undefined) tiles.push(tile('steps', s.steps, `in ${quantity(s.stepping_s, 's', 3)}`));
  if (s.cases) tiles.push(tile('cases', `${s.done} of ${s.cases}`, s.failed ? `${s.failed} failed` : 'none failed'));
  if (s.rows) tiles.push(tile('rows', `${s.done} of ${s.rows}`, s.response ? `response '${s.response}'` : ''));
  return el('header', {},
    data.batch ? el('nav', {}, el('a', { href: '../../report.html' }, `\u2190 ${data.batch}`)) : null,
    el('div', { class: 'title' }, el('h1', {}, titleOf(data)), badge(s.status, 'kkt_residual' in s)),
    el('p', { class: 'reason' }, sentence(reason?.replace('conditions of the motion', `conditions of the ${subject(data)}`)), meaning ? el('span', {}, ' ' + meaning.replace('motion', subject(data))) : null),
    s.warnings?.length ? el('ul', { class: 'warnings' }, s.warnings.map((w) => el('li', {}, prose(w)))) : null,
    tiles.length ? el('div', { class: 'tiles' }, tiles) : null);
}

/** Columns in which no row says anything are left out. */
export function table(heading, rows, kinds = []) {
  const said = heading.map((_, i) => i === 0 || rows.some((row) => row[i] !== '\u2013'));
  const words = (x, i) => (typeof x === 'string' && kinds[i] !== 'n' ? breakable(x) : x);
  const cell = (tag, x, i) => said[i] && el(tag, { class: kinds[i] ?? '' }, words(x, i));
  return el('div', { class: 'scroll' }, el('table', {},
    el('thead', {}, el('tr', {}, heading.map((h, i) => cell('th', h, i)))),
    el('tbody', {}, rows.map((row) => el('tr', {}, row.map((x, i) => cell('td', x, i)))))));
}

/** Name and unit of what a motion runs over: time, or a load factor. */
function abscissaOf(data) {
  const { abscissa = 'time', unit = 's' } = data.motion ?? { abscissa: data.charts[0]?.abscissa, unit: data.charts[0]?.abscissa_unit };
  return { name: abscissa.replace('_', ' '), unit };
}

const kMostUnsorted = 12;  // limits: of more, the nearest first

export function limits(data) {
  const s = data.summary, over = abscissaOf(data);
  const entries = Object.entries(s.constraints ?? {});
  if (entries.length === 0) return null;
  if (entries.length > kMostUnsorted) entries.sort(([, a], [, b]) => b.violation - a.violation);
  const unit = s.objective?.unit ?? 'kg', prices = Object.entries(s.prices ?? {});
  const price = (name) => prices.filter(([of]) => of === name || of.startsWith(`${name} at `)).reduce((sum, [, p]) => sum + p, 0);
  const rows = entries.map(([name, c]) => [
    name, quantity(c.limit, c.unit), quantity(c.max_abs_initial, c.unit), quantity(c.max_abs_final, c.unit),
    el('span', { class: c.violation > 1e-3 ? 'bad' : 'fine' }, excess(c.violation, isOwn(c))),
    errorOf(c) === undefined ? '\u2013' : plusMinus(share(errorOf(c) / c.limit)),
    c.at_time ? quantity(c.at_time, over.unit, 3) : '\u2013',
    price(name) ? quantity(price(name) / 100, unit, 3) : '\u2013',
  ]);
  for (const [of, p] of prices)  // walls, limits of a part
    if (!entries.some(([name]) => of === name || of.startsWith(`${name} at `)))
      rows.push([of, '\u2013', '\u2013', '\u2013', '\u2013', '\u2013', '\u2013', quantity(p / 100, unit, 3)]);
  return card('Limits',
    table(['limit', 'allowed', 'before', 'after', 'above it', 'error', over.unit === 's' ? 'at' : `at ${over.name}`, '1 % more saves'], rows, ['', 'n', 'n', 'n', 'n', 'n', 'n', 'n']),
    s.kkt ? el('p', { class: 'note' }, `Optimality conditions of the ${subject(data)}: ${prose(s.kkt)}.`) : null);
}

/** Bounds as a line, the start as a tick, the end as a dot. */
export function boundsBar(d) {
  const place = (x) => Math.max(0, Math.min(1, (x - d.lower) / (d.upper - d.lower || 1)));
  const start = el('i', { class: 'start' }), end = el('i', { class: 'end' });
  start.style.left = `${100 * place(d.initial)}%`;
  end.style.left = `${100 * place(d.final)}%`;
  return el('span', { class: 'bounds', title: `${quantity(d.lower, d.unit)} \u2026 ${quantity(d.upper, d.unit)}` }, start, end);
}

export function design(s) {
  const names = Object.keys(s.design ?? {});
  if (names.length === 0) return null;
  const rows = names.map((name) => {
    const d = { ...s.design_range[name], final: s.design[name] };
    const change = d.initial ? percent(d.final / d.initial - 1) : '';
    return [name, quantity(d.initial, d.unit), quantity(d.final, d.unit), change, boundsBar(d)];
  });
  return card('Design', table(['variable', 'start', 'end', 'change', 'between its bounds'], rows, ['', 'n', 'n', 'n', '']));
}

export function responses(s, abscissa) {
  const entries = Object.entries(s.responses ?? {});
  if (entries.length === 0) return null;
  const rows = entries.map(([name, r]) => [name, quantity(r.max_abs, r.unit),
    errorOf(r) === undefined ? '\u2013' : plusMinus(quantity(errorOf(r), r.unit, 2)), tick(r.at_time, 4),
    quantities([r.final].flat().map((x) => (x !== null && Math.abs(x) < 1e-9 * r.max_abs ? 0 : x)), r.unit),
    both(r.error?.end) === undefined ? '\u2013' : plusMinus(quantity(both(r.error.end), r.unit, 2))]);
  const at = abscissa?.abscissa_unit && abscissa.abscissa_unit !== '-' ? `at [${abscissa.abscissa_unit}]` : 'at';
  return card('Responses', table(['response', 'largest', 'error', at, 'at the end', 'error'], rows, ['', 'n', 'n', 'n', 'n', 'n']));
}

/** Derivatives of the figures of a motion: by a percent of each parameter. */
export function gradients(s) {
  const rows = [];
  for (const [response, figures] of Object.entries(s.gradients ?? {}))
    for (const [figure, g] of Object.entries(figures))
      for (const [key, slope] of Object.entries(g.by)) {
        const p = s.parameters[key];
        rows.push([`${response}, ${figure}`, quantity(g.value, g.unit), key, `${number(slope, 4)} ${per(g.unit, p.unit)}`,
          g.value && slope !== null ? percent(0.01 * slope * p.value / g.value) : '\u2013']);
      }
  if (!rows.length) return null;
  return card('Derivatives', table(['figure', 'value', 'parameter', 'derivative', '1 % more changes it by'], rows, ['', 'n', 'wrap', 'n', 'n']));
}
const kPowers = { '^2': '\u00b2', '^3': '\u00b3' };
const per = (above, below) => (below?.includes(' or ') ? `${above} per SI unit` : quotient(above, below)).replace(/\^[23]/g, (p) => kPowers[p]);
const quotient = (above, below) => (below && below !== '-' ? `${above && above !== '-' ? above : '1'}/${below.includes('/') ? `(${below})` : below}` : above === '-' ? '' : above);

export function references(s) {
  if (!s.references?.length) return null;
  const rows = s.references.map((r) => [r.changes.join(', ') || 'as the scene', r.formalisms.join(', '), quantity(r.size, s.unit), quantity(r.floor, s.unit, 2), number(r.floor / r.size, 2)]);
  const ratios = (s.ratios ?? []).map((r) => [r.formalism, r.to, r.pairs, r.error === null ? '\u2013' : '\u00d7 ' + number(r.error, 3), r.time === null ? '\u2013' : '\u00d7 ' + number(r.time, 3)]);
  return card('References and ratios',
    table(['motion', 'references', 'size', 'difference', 'relative'], rows, ['', '', 'n', 'n', 'n']),
    ratios.length ? table(['formalism', 'against', 'pairs', 'error', 'time'], ratios, ['', '', 'n', 'n', 'n']) : null);
}

/** Modes with their frequencies; a row shows its mode in the picture. */
function modes(s, clock) {
  const node = table(['mode', 'frequency [Hz]'], s.frequencies_hz.map((f, i) => [i + 1, number(f, 5)]), ['', 'n']);
  if (clock?.t.length !== s.frequencies_hz.length) return node;
  const rows = [...node.querySelectorAll('tbody tr')];
  for (const [i, row] of rows.entries()) {
    const show = () => clock.set(clock.t[i]);
    row.className = 'opens';
    row.tabIndex = 0;
    row.addEventListener('click', show);
    row.addEventListener('keydown', (event) => event.key === 'Enter' && show());
  }
  clock.listen(() => rows.forEach((row, i) => row.setAttribute('aria-current', i === Math.round(clock.record()))));
  return node;
}

/** Frequencies, parts, critical loads: what a run says besides. @param clock of modes; else null */
export function further(s, clock) {
  const blocks = [];
  if (s.frequencies_hz?.length)
    blocks.push(modes(s, clock));
  if (s.critical_loads?.length)
    blocks.push(table(['critical load', 'kind'], s.critical_loads.map((c) => [number(c.load, 5), c.limit_point ? 'limit point' : 'bifurcation']), ['', '']));
  const parts = Object.entries(s.parts ?? {});
  if (parts.length)
    blocks.push(table(['part', 'cells', 'modes', 'mass', 'accurate up to'],
      parts.map(([name, p]) => [name, p.cells, p.modes, quantity(p.mass, 'kg'), quantity(p.right_up_to_hz, 'Hz', 3)]), ['', 'n', 'n', 'n', 'n']));
  const title = [s.frequencies_hz?.length && 'modes', s.critical_loads?.length && 'critical loads', parts.length && 'meshed parts'].filter(Boolean).join(', ');
  return blocks.length ? card(title[0].toUpperCase() + title.slice(1), ...blocks) : null;
}

/** What a map was asked for beside the keys that were set. */
function mapped(s) {
  if (s.command !== 'map') return '';
  const axes = Object.entries(s.over);
  const over = axes.map(([name, a]) => `${name}=${Number(a.from.toPrecision(8))}:${Number(a.to.toPrecision(8))}`);
  return ` --over '${over.join(',')}' --points ${axes.map(([, a]) => a.points).join(',')}`;
}

/** A word of a command line, as a shell takes it. */
const quoted = (word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replace(/'/g, `'\\''`)}'`);

export function provenance(data) {
  const s = data.summary, list = el('dl', {});
  const add = (name, value) => value && list.append(el('dt', {}, name), el('dd', {}, value));
  add('command', s.arguments?.length ? `liesl ${s.arguments.map(quoted).join(' ')}`
    : `liesl ${s.command}${s.input ? ' ' + s.input : ''}${mapped(s)}${(s.overrides ?? []).map((o) => ` --set '${o}'`).join('')}`);
  add('overrides', s.overrides?.join('\u2003'));
  add('folder', data.folder);
  add('input (SHA-256)', s.input_sha256);
  if (s.space) add('computed', `${s.space}: ${s.space_reason}`);
  if (s.wall_s) add('time', `${quantity(s.wall_s, 's', 3)}${s.cpu_s ? `, processors ${quantity(s.cpu_s, 's', 3)}` : ''}`);
  if (s.newton_iterations) add('corrections', `${s.newton_iterations} in ${s.steps} step${s.steps === 1 ? '' : 's'}`);
  if (s.peak_memory_mb) add('memory', `${number(s.peak_memory_mb, 3)} MB`);
  add('versions', Object.entries(s.versions ?? {}).map(([n, v]) => `${n} ${v}`).join(' \u00b7 '));
  return card('Where it comes from', list);
}
