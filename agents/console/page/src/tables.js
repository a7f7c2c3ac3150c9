// Tables whose rows are filled anew while they are read.
//
//   const refusals = table({ id: 'refusals' }, ['Client', 'Times']);
//   refusals.fill([['anna', '3']]);              a cell is text, an element, or a whole `td`

import { clipped, element } from './dom.js';

/** @import { Attributes } from './dom.js' */

/** @typedef {string | number | Node} Cell */
/** @typedef {ReturnType<typeof table>} Table */

/** @param {Attributes} attributes @param {string[]} heads */
export function table(attributes, heads) {
  const body = element('tbody', {});
  /** @param {Cell} cell */
  const cellOf = (cell) => {
    if (cell instanceof HTMLTableCellElement) return cell;
    return element('td', {}, cell instanceof Node ? cell : clipped(String(cell)));
  };
  return {
    panel: element(
      'table',
      attributes,
      element('thead', {}, element('tr', {}, ...heads.map((name) => element('th', {}, name)))),
      body,
    ),
    /** @param {Cell[][]} rows */
    fill: (rows) => body.replaceChildren(...rows.map((cells) => element('tr', {}, ...cells.map(cellOf)))),
  };
}
