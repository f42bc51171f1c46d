// The page: reads its data, puts the cards together.

import { cases } from './cases.js';
import { timeCharts } from './charts.js';
import { Clock } from './clock.js';
import { cycles } from './cycles.js';
import { array, load } from './data.js';
import { el, isDark, setTheme } from './dom.js';
import { lean } from './lean.js';
import { maps } from './map.js';
import { Player } from './player.js';
import * as tables from './tables.js';

const kMuch = 120;     // pixels: a column so much shorter takes the next card
const kHighest = 760;  // pixels: of the picture

function page() {
  const data = load(), s = data.summary;
  document.title = `${tables.titleOf(data)} \u2013 liesl ${s.command ?? ''}`;
  const clock = data.motion ? new Clock(array(data.motion.t)) : null;
  const player = data.motion ? new Player(data.motion, clock, s) : null;
  const left = el('div', { class: 'column' }), right = el('div', { class: 'column' });
  const columns = el('div', { class: 'columns' }, left, right), main = el('main', {}, columns);
  document.body.append(themeButton(), tables.head(data), main, el('footer', {}, `liesl ${s.versions?.liesl ?? ''} \u00b7 ${s.command ?? ''}`));
  const add = (column, ...nodes) => column.append(...nodes.filter(Boolean));
  if (player) add(left, player.node);
  player?.start();
  const timed = player && !player.shapes ? clock : null;
  if (timed) add(right, ...timeCharts(data.charts, timed));
  const wide = [...lean(s), tables.gradients(s), maps(data), cycles(data, player), ...(data.cases ? cases(data) : [])];
  const limits = tables.limits(data);
  const shorter = (usual) => {
    const other = usual === left ? right : left;
    return twoColumns() && other.offsetHeight < usual.offsetHeight - kMuch ? other : usual;
  };
  if (!player) for (const chart of timeCharts(data.charts, null)) add(left.offsetHeight > right.offsetHeight ? right : left, chart);
  for (const node of [limits, tables.design(s)]) add(shorter(left), node);
  for (const node of [data.motion?.abscissa === 'frequency' || !limits ? tables.responses(s, data.charts[0]) : null,
    tables.references(s), tables.further(s, player?.modes ? clock : null)])
    add(shorter(right), node);
  add(main, ...wide, tables.provenance(data));
  for (const column of [left, right]) if (!column.childNodes.length) column.remove();
  if (!columns.childNodes.length) columns.remove();
  player?.node.classList.toggle('alone', left.childNodes.length === 1);  // it may be higher then
  main.classList.toggle('single', !(left.isConnected && right.isConnected));
  for (const column of [left, right]) keepInSight(column);
  if (player && left.isConnected && right.isConnected) fill(player.stage, left, right);
  addEventListener('keydown', (event) => {
    const typing = event.target.matches?.('input:not([type=range]), select, textarea');
    const sliding = event.target.matches?.('input[type=range]') && event.key.startsWith('Arrow');
    const pressing = event.target.matches?.('button, a, th') && (event.key === ' ' || event.key === 'Enter');
    if (typing || sliding || pressing || event.ctrlKey || event.metaKey || event.altKey) return;
    if (player?.key(event)) event.preventDefault();
  });
  requestAnimationFrame(() => (document.documentElement.dataset.ready = Math.round(performance.now())));
}

/** Are the two columns side by side, as in style.css? */
function twoColumns() {
  return matchMedia('(min-width: 981px)').matches;
}

/** The shorter column stays in sight while the longer one is read: from its top, or its end if it is higher than the window. */
function keepInSight(column) {
  const place = () => (column.style.top = `${Math.min(14, innerHeight - column.offsetHeight - 14)}px`);
  new ResizeObserver(place).observe(column);
  addEventListener('resize', place);
}

/** The picture is as much higher as its column is shorter than the other one and than the window. */
function fill(stage, column, other) {
  const place = () => {
    stage.style.height = '';  // as the style has it
    const free = Math.min(other.offsetHeight, innerHeight - 28) - column.offsetHeight;
    if (twoColumns() && free > 0) stage.style.height = `${Math.min(stage.offsetHeight + free, Math.max(stage.offsetHeight, kHighest))}px`;
  };
  new ResizeObserver(place).observe(other);
  addEventListener('resize', place);
}

function themeButton() {
  return el('button', { id: 'theme', title: 'light or dark', 'aria-label': 'light or dark', onclick: () => setTheme(!isDark()) }, '\u25d0');
}

page();
