// Columns of batches and comparisons as a reader calls them.

import { scaleOf } from './format.js';

const kNames = {
  mass_initial: 'mass before', mass_final: 'mass after', worst_constraint: 'worst limit, above it', worst_constraint_error: 'error of the worst limit',
  kkt_residual: 'KKT residual', kkt: 'KKT residual', load_change: 'change of the loads', newton_iterations: 'corrections', rejected_steps: 'halved steps',
  stepping_s: 'time of the steps', wall_s: 'time', cpu_s: 'processor time', cpu_spread: 'spread of the time', peak_memory_mb: 'memory',
  tangent_refreshes: 'tangents anew', energy_drift: 'drift of energy', momentum_drift: 'drift of momentum',
  angular_momentum_drift: 'drift of angular momentum', constraint_residual: 'residual of the joints', violation: 'worst limit, above it',
};
const kEnds = [[/^(.+)\.max_abs$/, '$1, largest'], [/^(.+)\.violation$/, '$1, above its limit'], [/^(.+)\.final\.([xyz])$/, '$1.$2 at the end'], [/^(.+)\.final$/, '$1 at the end']];

/** A name of liesl's own in words; of the user's without underscores. */
export function titleOf(name) {
  for (const [end, words] of kEnds) if (end.test(name)) return name.replace(end, words);
  return kNames[name] ?? name.replace(/_/g, ' ');
}

/** Shares of limits, where they are such, and of the loads. */
const kShares = /^(worst_constraint(_error)?|violation|load_change|.+\.violation)$/;

/** Its title, and one unit for all its numbers: {title, factor, shown}, shown = unit of number / factor. */
export function headingOf(column) {
  if (column.number && kShares.test(column.name)) return { title: titleOf(column.name), factor: 0.01, shown: '%' };
  const numbers = column.number ? column.cells.filter((x) => x !== null).map(Math.abs) : [];
  const { factor, unit } = scaleOf(numbers.length ? Math.max(...numbers) : 0, column.number ? column.unit : '');
  return { title: titleOf(column.name), factor, shown: unit };
}
