// What the board refused, to whom, how often and why, the most frequent first; and how much each client asks.

import { element } from './dom.js';
import { asComponents } from './names.js';
import { fact } from './live_answers.js';
import { table } from './tables.js';
import { text } from './datum.js';

/** @import { Activity } from './activity.js' */
/** @import { Connection } from './connection.js' */

const shown = 50;

/** @param {Connection} connection @param {Activity} activity @param {() => string} me */
export function showRefusals(connection, activity, me) {
  const count = element('span', { class: 'quiet', id: 'refusal-count' }, '0');
  const refusals = table({ id: 'refusals' }, ['Client', 'Refused', 'Times', 'The newest']);
  const clients = table({ id: 'clients' }, ['Client', 'Requests/s']);
  connection.follow('(board-refusal ?client ?symbol ?count ?sentence)', (answers) => {
    const told = answers.map(fact).sort((a, b) => b[3] - a[3]);
    count.textContent = String(told.length);
    refusals.fill(told.slice(0, shown).map(([, client, symbol, times, sentence]) => [asComponents(text(client), me()), text(symbol), times, text(sentence)]));
  });
  const panel = element('details', { class: 'goals' }, element('summary', {}, 'Refused by the board ', count), refusals.panel, clients.panel);
  activity.shownIn(panel, (sample) =>
    clients.fill((sample?.clients ?? []).slice(0, shown).map((client) => [asComponents(client.name, me()) || '(no hello)', client.requests_per_second])),
  );
  return panel;
}
