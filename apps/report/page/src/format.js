// Numbers as a reader wants them: a unit of the right size, few digits, signs that show.

const kMinus = '\u2212', kTimes = '\u00d7', kThin = '\u202f', kMicro = '\u00b5';

// SI unit -> [factor, name], from the largest on; the first whose factor the value reaches is taken.
const kUnits = {
  m: [[1, 'm'], [1e-3, 'mm'], [1e-6, kMicro + 'm']],
  kg: [[1, 'kg'], [1e-3, 'g'], [1e-6, 'mg']],
  s: [[1, 's'], [1e-3, 'ms'], [1e-6, kMicro + 's']],
  Pa: [[1e9, 'GPa'], [1e6, 'MPa'], [1e3, 'kPa'], [1, 'Pa']],
  N: [[1e3, 'kN'], [1, 'N'], [1e-3, 'mN']],
  'N m': [[1e3, 'kN m'], [1, 'N m'], [1e-3, 'mN m']],
  J: [[1e3, 'kJ'], [1, 'J'], [1e-3, 'mJ']],
  Hz: [[1e3, 'kHz'], [1, 'Hz']],
};
// Below a metre engineers speak of millimetres, below a kilogram of grams.
const kFrom = { m: 1, kg: 1, s: 0.1 };

/** {factor, unit}: shown value = value / factor. */
export function scaleOf(size, unit) {
  const list = kUnits[unit];
  if (!list || !(size > 0)) return { factor: 1, unit: unit || '' };
  for (const [factor, name] of list)
    if (size >= factor * (factor === 1 ? (kFrom[unit] ?? 1) : 1) * 0.999) return { factor, unit: name };
  const [factor, name] = list[list.length - 1];
  return { factor, unit: name };
}

/** A number with so many digits that count, without exponents where they are not needed. */
export function number(x, digits = 4) {
  if (x === null || x === undefined || Number.isNaN(x)) return '\u2013';
  if (!Number.isFinite(x)) return x > 0 ? '\u221e' : kMinus + '\u221e';
  if (x === 0) return '0';
  const size = Math.abs(x);
  let text;
  if (size >= 1e6 || size < 1e-4) {
    const [mantissa, exponent] = x.toExponential(digits - 1).split('e');
    text = Number(mantissa) + kTimes + '10' + superscript(Number(exponent));
  } else {
    const places = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
    text = Number.isInteger(x) && size < 1e6 ? String(x) : x.toFixed(Math.min(places, 8));
  }
  return text.replace(/-/g, kMinus);
}

/** A number without zeros at its end: of axes, and of what a person has chosen. */
export function tick(x, digits = 4) {
  return number(x, digits).replace(/(\.\d*?)0+(?!\d)/, '$1').replace(/\.(?!\d)/, '');
}

function superscript(exponent) {
  const digits = '\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079';
  const sign = exponent < 0 ? '\u207b' : '';
  return sign + [...String(Math.abs(exponent))].map((d) => digits[Number(d)]).join('');
}

/** A sentence of the program with the signs of print: "\u22120.4", "\u00b1 1", "6.5\u00d710\u207b\u2075". */
export function prose(text) {
  return text.replace(/\+-/g, '\u00b1').replace(/(\d)e([+-]\d+)\b/g, (_, digit, exponent) => digit + kTimes + '10' + superscript(Number(exponent)))
    .replace(/(^|[\s(])-(?=\d)/g, `$1${kMinus}`);
}

/** Of a column with numbers of several units, "m or rad", none of them; of a number "-" none, too. */
export const plainUnit = (unit) => (!unit || unit === '-' || unit.includes(' or ') ? '' : unit);

/** "12.4 mm" */
export function quantity(x, unit, digits = 4) {
  if (x === null || x === undefined || Number.isNaN(x)) return '\u2013';
  const { factor, unit: name } = scaleOf(Math.abs(x), unit === '-' ? '' : unit);
  return number(x / factor, digits) + (name ? '\u00a0' + name : '');
}

/** Quantities of a list in one unit, that of the largest: "97.9 ms", "103.2 ms". */
export function inOneUnit(xs, unit, digits = 4) {
  const { factor, unit: name } = scaleOf(Math.max(0, ...xs.map(Math.abs)), unit);
  return (x) => number(x / factor, digits) + (name ? '\u00a0' + name : '');
}

/** "(12.4, 0, \u22123.1) mm"; of one number "12.4 mm" */
export function quantities(xs, unit, digits = 4) {
  if (xs.length === 1) return quantity(xs[0], unit, digits);
  const { factor, unit: name } = scaleOf(Math.max(...xs.map(Math.abs)), unit === '-' ? '' : unit);
  return `(${xs.map((x) => tick(x / factor, digits)).join(', ')})${name ? '\u00a0' + name : ''}`;
}

/** By how much a limit is exceeded; a function of one's own has a number, in a unit of its own, in place of a share. */
export function excess(value, own) {
  if (!own || value === null || value === undefined) return percent(value);
  return (value > 0 ? '+' : '') + number(value, 4);
}

/** That of `constraints` which is violated most, or has least to spare. */
export const worstLimit = (summary) => Object.values(summary.constraints ?? {}).sort((a, b) => b.violation - a.violation)[0];

/** Is this limit, an entry of `constraints`, a function of one's own? */
export const isOwn = (limit) => limit?.response === 'own function';

/** "0.075 %", of what has no sign. */
export const share = (x) => number(100 * x, 2) + kThin + '%';

/** "+26 %", "\u22120.4 %"; what is next to nothing is "0 %". */
export function percent(share) {
  if (share === null || share === undefined || Number.isNaN(share)) return '\u2013';
  const x = 100 * share, size = Math.abs(x);
  if (size < 5e-4) return '0' + kThin + '%';
  const digits = size >= 100 ? 0 : size >= 10 ? 1 : size >= 1 ? 2 : 3;
  return (x > 0 ? '+' : kMinus) + size.toFixed(digits) + kThin + '%';
}
