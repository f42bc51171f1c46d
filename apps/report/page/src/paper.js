// Wide tables on paper: columns that say something, in as many tables below each other as the sheet asks for.

import { el } from './dom.js';

const kSheet = 660, kLetter = 5.6, kGap = 9;  // pixels: width for a table, of a letter, between columns
const kLongest = 46;                          // letters of a line of text

const kBreaks = /([_/\\,=]|\.(?=[a-z_]))(?=.)/gi;  // lines may end behind these
const breakable = (text) => String(text).replace(kBreaks, '$1\u200b');
const longestWord = (text) => Math.max(...breakable(text).split(/[\s\u200b]/).map((word) => word.length));

/** Tables and a line on what is the same in all rows. @param label column -> heading @param cell (column, row) -> text */
export function paperTables(columns, rows, label, cell) {
  const [first, ...others] = columns;
  if (!first) return [];
  const same = (c) => rows.length > 1 && rows.every((row) => c.cells[row] === c.cells[rows[0]]);
  const constant = others.filter(same), shown = others.filter((c) => !constant.includes(c));
  const width = (c) => kGap + kLetter * Math.max(longestWord(label(c)), Math.min(kLongest, Math.max(...rows.map((row) => String(cell(c, row)).length))));
  const blocks = [[first]];
  let used = width(first);
  for (const c of shown) {
    if (used + width(c) > kSheet && blocks[blocks.length - 1].length > 1) {
      blocks.push([first]);
      used = width(first);
    }
    blocks[blocks.length - 1].push(c);
    used += width(c);
  }
  const common = constant.map((c) => `${label(c)} ${cell(c, rows[0])}`).join(' \u00b7 ');
  return [common ? el('p', { class: 'note' }, `The same in all rows: ${breakable(common)}`) : null,
    ...blocks.map((block) => oneTable(block, rows, label, cell))].filter(Boolean);
}

function oneTable(columns, rows, label, cell) {
  const kind = (c) => (c.number ? 'n' : 'text');
  const narrow = columns.length < 4 && columns.every((c) => c.number);
  return el('table', { class: narrow && 'narrow' },
    el('thead', {}, el('tr', {}, columns.map((c) => el('th', { class: kind(c) }, breakable(label(c)))))),
    el('tbody', {}, rows.map((row) => el('tr', {}, columns.map((c) => el('td', { class: kind(c) }, c.number ? cell(c, row) : breakable(cell(c, row))))))));
}
