// The instants whose loads a cycle keeps: buttons that go there, and what the loads are.

import { el } from './dom.js';
import { inOneUnit, quantity } from './format.js';
import { LoadArrows, readLoads } from './loads.js';

/** @returns {largest(cycle), show(cycle), node}; null where no loads are kept */
export function loadCases(data, player, abscissaUnit) {
  const loads = readLoads(data.loads);
  if (!loads.length) return null;
  const arrows = player?.view ? new LoadArrows(player.view, loads) : null;
  const time = inOneUnit(loads.map((l) => l.at), 's');
  const name = (at) => (abscissaUnit === '-' ? `load factor ${Number(at.toPrecision(4))}` : time(at));
  const buttons = el('div', { class: 'controls row' }), table = el('tbody', {});
  const node = el('div', { class: 'loads' }, el('h3', {}, 'Loads'), buttons,
    el('div', { class: 'scroll' }, el('table', { id: 'loads' }, el('thead', {}, el('tr', {},
      el('th', {}, 'part'), ['at', 'largest force', 'largest moment'].map((t) => el('th', { class: 'n' }, t)))), table)),
    el('p', { class: 'note' }, 'The equivalent static loads of the cycle at the instants where they, or the limit that bounds the design most, are largest. The arrows are the forces on ' +
      'the nodes of beams, on the interfaces of meshed parts and, as resultants of patches of the mesh, between them, drawn on the motion of the final design, all cycles to one scale.'));
  let shown = null, cycle = null, told = abscissaUnit !== '-';  // of statics the last one is shown at first

  const instants = () => [...new Set(loads.filter((l) => l.cycle === cycle).map((l) => `${l.at}|${l.scenario}`))]
    .map((key) => ({ at: Number(key.split('|')[0]), scenario: key.slice(key.indexOf('|') + 1) })).sort((a, b) => a.at - b.at);
  const nearest = (at) => instants().reduce((best, i) => (best && Math.abs(best.at - at) <= Math.abs(i.at - at) ? best : i), null);

  /** Arrows of an instant, and the picture at it; null: none. */
  const draw = (instant) => {
    if (instant) player?.toggle(false);
    shown = instant;
    for (const button of buttons.querySelectorAll('button')) button.setAttribute('aria-pressed', String(!!instant && Number(button.dataset.at) === instant.at && button.dataset.scenario === instant.scenario));
    if (!arrows) return;
    arrows.show(instant ? loads.filter((l) => l.cycle === cycle && l.at === instant.at && l.scenario === instant.scenario) : []);
    if (instant) player.clock.set(instant.at);
  };
  player?.clock.listen((t) => {
    if (shown && Math.abs(t - shown.at) > 1e-6 * Math.abs(player.clock.last - player.clock.first)) draw(null);
  });

  return {
    node,
    /** Largest force of a cycle, N. */
    largest: (number) => Math.max(...loads.filter((l) => l.cycle === number).map((l) => l.largest)),
    known: (number) => loads.some((l) => l.cycle === number),
    show(number) {
      const at = shown?.at;
      cycle = number;
      buttons.replaceChildren(...(arrows ? instants() : []).map((i) => el('button', { 'data-at': i.at, 'data-scenario': i.scenario, 'aria-pressed': 'false',
        title: 'show the loads of this instant', onclick: () => draw(shown && shown.at === i.at && shown.scenario === i.scenario ? null : i) },
      name(i.at) + (i.scenario ? ` (${i.scenario})` : ''))));
      const rows = loads.filter((l) => l.cycle === cycle);
      if (!rows.length && data.loads.thinned) table.replaceChildren(el('tr', {}, el('td', { colspan: 4 }, 'left out of the page; those of every cycle are in cycle_loads.csv')));
      else table.replaceChildren(...rows.map((l) => el('tr', {},
        el('td', {}, l.body), el('td', { class: 'n' }, name(l.at) + (l.scenario ? ` (${l.scenario})` : '')),
        el('td', { class: 'n' }, quantity(l.largest, 'N')), el('td', { class: 'n' }, quantity(l.moment, 'N m')))));
      draw(at !== undefined ? nearest(at) : told || !arrows ? null : nearest(player.clock.last));
      told = true;
    },
  };
}
