// Who serves whom in which role, and where another stands in for the one that is wired.

import { clipped, element } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */

/** @type {Record<string, string>} */
const said = { wired: '', 'stands-in': 'stands in', absent: 'is away' };
const shown = 64;

/** @param {Connection} connection */
export function showServed(connection) {
  const body = element('tbody', {});
  const heads = ['Client', 'Role', 'Is played by', ''].map((name) => element('th', {}, name));
  connection.follow('(holder ?client ?role ?server ?state)', (answers) => {
    const rows = answers.map((answer) => fact(answer).slice(1).map(text)).sort();
    body.replaceChildren(
      ...rows
        .slice(0, shown)
        .map(([client, role, server, state]) =>
          element(
            'tr',
            { class: state === 'wired' ? '' : 'warn' },
            ...[client, role, server, said[state] ?? state].map((cell) => element('td', {}, clipped(cell, 64))),
          ),
        ),
    );
  });
  const table = element('table', { id: 'served' }, element('thead', {}, element('tr', {}, ...heads)), body);
  return element('details', { class: 'goals', open: true }, element('summary', {}, 'Who serves whom'), table);
}
