// The page: reads its data, puts the cards together.

import { cases } from './cases.js';
import { timeChart } from './charts.js';
import { Clock } from './clock.js';
import { cycles } from './cycles.js';
import { array, load } from './data.js';
import { el, isDark, setTheme } from './dom.js';
import { maps } from './map.js';
import { Player } from './player.js';
import * as tables from './tables.js';

function page() {
  const data = load(), s = data.summary;
  document.title = `${s.name || data.folder} \u2013 liesl ${s.command ?? ''}`;
  const clock = data.motion ? new Clock(array(data.motion.t)) : null;
  const player = data.motion ? new Player(data.motion, clock, worstInstant(s), s.load_cases) : null;
  const left = el('div', { class: 'column' }), right = el('div', { class: 'column' });
  const main = el('main', {}, left, right);
  document.body.append(themeButton(), tables.head(data), main, el('footer', {}, `liesl ${s.versions?.liesl ?? ''} \u00b7 ${s.command ?? ''}`));
  const add = (column, ...nodes) => column.append(...nodes.filter(Boolean));
  if (player) add(left, player.node);
  player?.start();
  const timed = player && !player.shapes ? clock : null;
  if (!player || timed) add(right, ...data.charts.map((d) => timeChart(d, timed)));
  const wide = [maps(data), cycles(data, player), ...(data.cases ? cases(data) : [])];
  add(left, tables.limits(s));
  add(twoColumns() && right.offsetHeight < left.offsetHeight ? right : left, tables.design(s));
  add(right, data.motion?.abscissa === 'frequency' || !tables.limits(s) ? tables.responses(s, data.charts[0]) : null, tables.references(s), tables.further(s, player?.modes ? clock : null), tables.gradients(s));
  add(main, ...wide.filter(Boolean).map((node) => (node.classList.add('wide'), node)));
  const origin = tables.provenance(data);
  origin.classList.add('wide');
  add(main, origin);
  if (!left.childNodes.length) left.remove();
  if (!right.childNodes.length) right.remove();
  main.classList.toggle('single', !(left.isConnected && right.isConnected));
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

/** When the limit is reached that is violated most, or has least to spare. */
function worstInstant(s) {
  const worst = Object.values(s.constraints ?? {}).sort((a, b) => b.violation - a.violation)[0];
  return worst?.at_time > 0 ? worst.at_time : undefined;
}

function themeButton() {
  return el('button', { id: 'theme', title: 'light or dark', 'aria-label': 'light or dark', onclick: () => setTheme(!isDark()) }, '\u25d0');
}

page();
