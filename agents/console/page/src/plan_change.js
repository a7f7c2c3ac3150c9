// The old and the new plan side by side: what both have stands in one row.

import { clipped, element } from './dom.js';
import { text, write } from './datum.js';

/** @import { Datum } from './messages' */

// Rows of [old, new], either of them missing: the longest common part in its order.
/** @param {string[]} before @param {string[]} now */
function aligned(before, now) {
  const common = Array.from({ length: before.length + 1 }, () => Array(now.length + 1).fill(0));
  for (let i = before.length - 1; i >= 0; --i) {
    for (let j = now.length - 1; j >= 0; --j) {
      common[i][j] = before[i] === now[j] ? common[i + 1][j + 1] + 1 : Math.max(common[i + 1][j], common[i][j + 1]);
    }
  }
  /** @type {[old: string | null, made: string | null][]} */
  const rows = [];
  let i = 0;
  let j = 0;
  while (i < before.length || j < now.length) {
    if (i < before.length && j < now.length && before[i] === now[j]) rows.push([before[i++], now[j++]]);
    else if (j === now.length || (i < before.length && common[i + 1][j] >= common[i][j + 1])) rows.push([before[i++], null]);
    else rows.push([null, now[j++]]);
  }
  return rows;
}

// `begun`: the operations of the old plan that were begun before the new one was made.
/** @param {Datum[]} before @param {Datum[]} now @param {Set<string>} begun */
export function planChange(before, now, begun) {
  /** @param {string | null} operation @param {string} kind @param {string} mark */
  const cell = (operation, kind, mark) =>
    element(
      'td',
      { class: operation ? kind : '' },
      operation && element('code', {}, clipped(operation, 80)),
      operation && mark && element('small', {}, ` ${mark}`),
    );
  const rows = aligned(before.map(write), now.map(write)).map(([old, made]) =>
    element(
      'tr',
      {},
      cell(old, made ? 'kept' : 'dropped', made ? '' : begun.has(old ?? '') ? 'begun' : 'dropped'),
      cell(made, old ? 'kept' : 'made', old ? 'kept' : 'new'),
    ),
  );
  return element(
    'table',
    { class: 'plans' },
    element('thead', {}, element('tr', {}, element('th', {}, 'The plan before'), element('th', {}, 'From here on'))),
    element('tbody', {}, ...rows),
  );
}

// `(plan GOAL (OPERATION ...))`, of a story's entry; null for another.
/** @param {Datum} detail @returns {{ goal: Datum, operations: Datum[] } | null} */
export function planIn(detail) {
  if (!Array.isArray(detail) || text(detail[0]) !== 'plan') return null;
  const [, goal, operations] = detail;
  return Array.isArray(operations) ? { goal, operations } : null;
}
