// What `liesl lean` found: the model, its error and its price beside those it was found from, and why.

import { card, el } from './dom.js';
import { number, percent, prose, quantity } from './format.js';
import { table, tile } from './tables.js';

const share = (x) => percent(x).replace('+', '');

export function leanTiles(s) {
  if (s.command !== 'lean') return [];
  const faster = s.time_given_s / s.time_s;
  return [tile(`error of '${s.response}'`, share(s.error), `${share(s.tolerance)} allowed`, s.error > s.tolerance ? 'bad' : 'fine'),
    tile('time', `${quantity(s.time_given_s, 's', 3)} \u2192 ${quantity(s.time_s, 's', 3)}`, faster > 1 ? `${number(faster, 2)} times as fast` : 'not faster than given')];
}

/** Cards of a lean model; none of another command. */
export function lean(s) {
  if (s.command !== 'lean' || !s.lean) return [];
  const models = [['lean', s.lean, s.error, s.time_s], ['as given', s.given, s.error_given, s.time_given_s],
    ['reference', s.reference, s.reference_error, s.time_reference_s], ['held out', s.held_out, null, s.time_held_out_s]];
  const rows = models.filter(([, m]) => m).map(([name, m, error, time]) => [name, m.space, m.steps, quantity(m.step, 's', 3), m.tangent,
    Object.entries(m.beams ?? {}).map(([beam, b]) => `${beam} ${mesh(b)}`).join(', ') || '\u2013', share(error), quantity(time, 's', 3)]);
  const model = card('Lean model',
    table(['model', 'space', 'steps', 'step', 'tangent', 'beams', 'error', 'time'], rows, ['', '', 'n', 'n', '', 'wrap', 'n', 'n']),
    el('p', { class: 'note' }, `Errors are of the largest '${s.response}', against the reference; that of the lean model in the end against the run held out, that decided nothing. ${s.runs} runs.`),
    s.changes?.length ? el('h3', {}, 'Changes of the scene') : null,
    s.changes?.length ? el('ul', { class: 'changes' }, s.changes.map((c) => el('li', {}, c))) : null);
  const why = s.decisions?.length ? card('Decisions', table(['about', 'choice', 'figure', 'limit', 'evidence'],
    s.decisions.map((d) => [d.about, prose(d.choice), share(d.figure), share(d.limit), prose(d.evidence ?? '')]), ['', 'wrap', 'n', 'n', 'wrap'])) : null;
  why?.classList.add('long');
  return [model, why];
}

function mesh(b) {
  if (b.rigid) return 'rigid';
  if (b.modes !== null && b.modes !== undefined) return `${b.modes} modes of ${b.elements}`;
  return `${b.elements}${b.segments ? ' segments' : ''}${b.order === 4 ? ' of order 4' : ''}`;
}
