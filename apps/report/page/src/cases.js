// Cases of a batch and rows of a comparison: a table to sort and filter, and points of two columns.

import { card, el } from './dom.js';
import { badge, succeeded } from './tables.js';
import { number, plainUnit, tick } from './format.js';
import { headingOf } from './headings.js';
import { kSeries } from './colors.js';
import { swatch } from './charts.js';
import { paperTables } from './paper.js';
import { Scatter } from './scatter.js';

const kMostRows = 400;  // shown at once

export function cases(data) {
  const columns = data.cases.columns, compare = data.summary.command === 'compare';
  const table = new CaseTable(columns, data, compare);
  return [compare ? precision(table) : pairs(table), table.card()];
}

class CaseTable {
  constructor(all, data, compare) {
    const units = data.summary.input_units ?? {};
    const columns = all.filter((c, i) => i === 0 || c.cells.some((x) => x !== null && x !== '')).map((c) => ({ ...c, unit: plainUnit(c.unit || units[c.name]) }))
      .map((c) => ({ ...c, ...headingOf(c) }));
    Object.assign(this, { columns, data, compare, sorted: null, down: false, listeners: [] });
    this.certified = columns.some((c) => c.name.startsWith('kkt'));
    this.count = columns.length ? columns[0].cells.length : 0;
    this.rows = [...Array(this.count).keys()];
  }
  column(name) { return this.columns.find((c) => c.name === name); }
  numeric() { return this.columns.filter((c) => c.number); }
  heading(c) { return c.shown ? `${c.title} [${c.shown}]` : c.title; }
  /** A number in the unit of its heading; NaN: none. */
  value(c, row) { return (c.cells[row] ?? NaN) / c.factor; }
  cell(c, row) {
    const x = c.cells[row];
    return x === null || x === '' ? '\u2013' : c.number ? (c.unit ? number(x / c.factor, 4) : tick(x / c.factor, 4)) : x;
  }

  card() {
    this.filter = el('input', { type: 'search', id: 'filter', placeholder: 'filter: text, or column > value; another', oninput: () => this.update() });
    this.head = el('tr', {}, this.columns.map((c) => el('th', { class: c.number ? 'n' : '', tabindex: 0, title: `sort by ${c.name}${c.unit ? `, ${c.unit}` : ''}`,
      onclick: () => this.sort(c), onkeydown: (e) => e.key === 'Enter' && this.sort(c) }, this.heading(c))));
    this.body = el('tbody', {});
    this.note = el('p', { class: 'note', 'aria-live': 'polite' });
    this.said = el('div', { id: 'said', 'aria-live': 'polite' });
    const paper = el('div', { class: 'printed paper' });
    addEventListener('beforeprint', () =>
      paper.replaceChildren(...paperTables(this.columns, this.rows.slice(0, kMostRows), (c) => this.heading(c), (c, row) => this.cell(c, row))));
    addEventListener('afterprint', () => paper.replaceChildren());
    const node = card(this.compare ? 'Rows' : 'Cases', el('div', { class: 'controls two' }, this.filter, this.note), this.said, paper,
      el('div', { class: 'scroll tall' }, el('table', { id: 'cases' }, el('thead', {}, this.head), this.body)));
    this.update();
    return node;
  }

  sort(column) {
    this.down = this.sorted === column ? !this.down : false;
    this.sorted = column;
    this.update();
  }

  /** Terms of the filter, each a text or `column > value`; column: null if there is none of that name. */
  terms() {
    return this.filter.value.split(/\s*;\s*|\s+and\s+/).filter(Boolean).map((term) => {
      const [, name, sign, value] = term.match(/^(.*?)\s*(<=|>=|<|>|=)\s*(\S.*)$/) ?? [];
      const key = name?.trim();
      return { text: term.toLowerCase().trim(), key, sign, value, column: key ? this.column(key) ?? this.columns.find((c) => c.title === key) ?? null : null };
    });
  }

  /** Is the row one that all terms leave? */
  matches(row, terms) {
    return terms.every(({ text, key, sign, value, column }) => {
      if (!column) return this.columns.some((c) => String(c.cells[row] ?? '').toLowerCase().includes(text));
      const x = column.cells[row], y = column.number ? Number(value) * (column.name === key ? 1 : column.factor) : value;
      if (x === null) return false;
      return { '<': x < y, '>': x > y, '<=': x <= y, '>=': x >= y, '=': x === y }[sign];
    });
  }

  update() {
    const terms = this.terms();
    this.rows = [...Array(this.count).keys()].filter((row) => this.matches(row, terms));
    if (this.sorted) {
      const value = (row) => this.sorted.cells[row] ?? (this.sorted.number ? Infinity : '');
      this.rows.sort((a, b) => (value(a) < value(b) ? -1 : value(a) > value(b) ? 1 : 0) * (this.down ? -1 : 1));
    }
    [...this.head.children].forEach((th, i) =>
      th.setAttribute('aria-sort', this.columns[i] === this.sorted ? (this.down ? 'descending' : 'ascending') : 'none'));
    this.body.replaceChildren(...this.rows.slice(0, kMostRows).map((row) => this.line(row)));
    const more = this.rows.length > kMostRows ? `, the first ${kMostRows} shown` : this.rows.length ? '' : advice(terms);
    this.note.textContent = this.count ? `${this.rows.length} of ${this.count}${more}` : `no ${this.compare ? 'row' : 'case'} has ended yet`;
    for (const listener of this.listeners) listener();
  }

  line(row) {
    const opens = this.address(row);
    return el('tr', { class: opens || !this.compare ? 'opens' : '', onclick: () => this.open(row) }, this.columns.map((c, i) => {
      const text = this.cell(c, row);
      const content = c.name === 'status' ? badge(text, this.certified) : i === 0 && opens ? el('a', { href: opens }, text) : text;
      return el('td', { class: c.number ? 'n' : 'text', title: c.number ? null : text }, content);
    }));
  }

  /** Page of a case, if it has one. */
  address(row) {
    const name = String(this.columns[0].cells[row]);
    return this.data.reported?.includes(name) ? `cases/${encodeURIComponent(name)}/report.html` : null;
  }
  /** Its page, or what the table has of it: batches of many cases have pages where they are asked for. */
  open(row) {
    const address = this.address(row);
    if (address) location.href = address;
    if (address || this.compare || !this.said) return;
    const [first, ...columns] = this.columns, name = String(first.cells[row]);
    this.said.replaceChildren(el('h3', {}, `Case ${name}`),
      el('dl', { class: 'figures' }, columns.filter((c) => c.cells[row] !== null && c.cells[row] !== '')
        .flatMap((c) => [el('dt', {}, c.title), el('dd', {}, this.told(c, row))])),
      el('p', { class: 'note' }, `It has no page yet: "liesl report ${this.data.folder}/cases/${name}" writes it, "liesl report ${this.data.folder}" then links it here.`));
    this.said.scrollIntoView({ block: 'nearest' });
  }

  /** A cell with its unit. */
  told(c, row) { return c.shown && c.cells[row] !== null ? `${this.cell(c, row)} ${c.shown}` : this.cell(c, row); }

  describe(row, names) {
    const title = this.columns[0];
    return [`${title.name} ${title.cells[row]}`, ...this.columns.filter((c) => names.includes(c.name)).map((c) => `${c.title}: ${this.told(c, row)}`)];
  }
}

const choose = (id, columns, chosen, change) => {
  const node = el('select', { id, onchange: change }, columns.map((c) => el('option', { value: c.name, selected: c.name === chosen }, c.title)));
  return node;
};

/** Why a filter may have left nothing. */
function advice(terms) {
  const unknown = terms.find((term) => term.key && !term.column), text = terms.find(({ column, value }) => column?.number && Number.isNaN(Number(value)));
  return unknown ? `; there is no column '${unknown.key}'` : text ? `; '${text.value}' is no number: "speed > 130; cycles > 3" joins two conditions` : '';
}

/** A choice with its name, on one line. */
const named = (text, node) => el('span', { class: 'named' }, el('label', { for: node.id }, text), ' ', node);

/** A batch: any two columns, coloured by a third. */
function pairs(table) {
  if (!table.count) return null;
  const columns = table.numeric().filter((c) => c !== table.columns[0]);
  if (columns.length < 2) return card('', el('p', { class: 'note' }, 'No two columns of numbers to compare.'));
  const inputs = columns.filter((c) => new Set(c.cells).size > 1);
  const first = inputs[0] ?? columns[0], objective = table.column('mass_final') ?? inputs[inputs.length - 1] ?? columns[1];
  const third = inputs.find((c) => c !== first && c !== objective) ?? first;
  const scatter = new Scatter({
    describe: (row) => table.describe(row, [x.value, y.value, shade.value, 'status', ...table.columns.slice(1, 5).map((c) => c.name)]),
    open: (row) => table.open(row),
  });
  const status = table.column('status'), failed = (row) => Boolean(status) && !succeeded(status.cells[row]);
  const update = () => {
    const cx = table.column(x.value), cy = table.column(y.value), cs = table.column(shade.value);
    const values = cs.cells.filter((v) => v !== null), low = Math.min(...values), high = Math.max(...values);
    key.replaceChildren(shadeKey(cs, low, high));
    scatter.set(table.rows.map((row) => ({ x: table.value(cx, row), y: table.value(cy, row), row, shade: (cs.cells[row] - low) / (high - low || 1), hollow: failed(row) })),
      { xlabel: table.heading(cx), ylabel: table.heading(cy), shade: true });
  };
  const x = choose('scatter-x', columns, first.name, update), y = choose('scatter-y', columns, objective.name, update),
    shade = choose('scatter-c', columns, third.name, update), key = el('span', { class: 'colours inline' });
  table.listeners.push(update);
  const node = card('Any two columns', el('div', { class: 'controls row' },
    named('across', x), named('upwards', y), named('colour', shade), key), scatter.node,
    table.rows.some(failed) ? el('p', { class: 'note' }, 'Hollow: cases that did not end as they should, as their status says.') : null);
  return node;
}

function shadeKey(column, low, high) {
  const strip = el('span', { class: 'strip viridis' });
  return el('span', {}, tick(low / column.factor, 3), ' ', strip, ' ', tick(high / column.factor, 3), column.shown ? ` ${column.shown}` : '');
}

const kMeasured = new Set(['run', 'error', 'cpu_s', 'cpu_spread', 'steps', 'newton_iterations', 'tangent_refreshes', 'rejected_steps',
  'factorizations', 'energy_drift', 'momentum_drift', 'angular_momentum_drift', 'constraint_residual', 'floor', 'reason',
  'simulations', 'sensitivities', 'mass', 'violation', 'kkt']);

/** A comparison: error, or what was optimised, against time, the fewer of both the better. */
function precision(table) {
  const error = table.column('error'), time = table.column('cpu_s');
  const value = error ?? table.column(table.data.summary.response) ?? table.column('mass') ?? table.column('mass_final');
  if (!value?.number || !time?.number) return null;
  const varied = table.columns.filter((c) => !kMeasured.has(c.name) && c !== value);
  const group = table.column('formalism') ?? table.column('method') ?? varied.find((c) => !c.number && new Set(c.cells).size > 1) ?? table.columns[1];
  const groups = [...new Set(group.cells.map(String))];
  const scatter = new Scatter({ describe: (row) => table.describe(row, [...varied.map((c) => c.name), value.name, 'cpu_s', 'steps', 'violation', 'kkt']) });
  const violated = (row) => table.column('violation')?.cells[row] > 1e-3;
  table.listeners.push(() => scatter.set(
    table.rows.map((row) => ({ x: table.value(time, row), y: table.value(value, row), row, group: String(group.cells[row]), hollow: violated(row) })),
    { xlabel: table.heading(time), ylabel: table.heading(value), logx: true, logy: value === error, groups, lines: true }));
  const legend = el('div', { class: 'legend' }, groups.map((g, i) => el('span', {}, swatch(kSeries[i % kSeries.length]), g)));
  const title = value.title.replace('_', ' ');
  const node = card(`${title[0].toUpperCase()}${title.slice(1)} against time`, legend, scatter.node,
    el('p', { class: 'note' }, 'Each point is a row of the table; lines join those that no other of the same kind beats in both.',
      table.rows.some(violated) ? ' Hollow: limits are not met.' : ''));
  return node;
}
