// What the board refused, to whom, how often and why, the most frequent first.

import { clipped, element } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

const shown = 50;

export function showRefusals(connection) {
  const count = element('span', { class: 'quiet', id: 'refusal-count' }, '0');
  const body = element('tbody', {});
  const heads = ['Client', 'Refused', 'Times', 'The newest'].map((name) => element('th', {}, name));
  const table = element('table', { id: 'refusals' }, element('thead', {}, element('tr', {}, ...heads)), body);
  connection.follow('(board-refusal ?client ?symbol ?count ?sentence)', (answers) => {
    const refusals = answers.map(fact).sort((a, b) => b[3] - a[3]);
    count.textContent = String(refusals.length);
    const rows = refusals.slice(0, shown).map(([, client, symbol, times, sentence]) =>
      element(
        'tr',
        {},
        ...[text(client), text(symbol), String(times), text(sentence)].map((cell) => element('td', {}, clipped(cell))),
      ),
    );
    body.replaceChildren(...rows);
  });
  return element('details', { class: 'goals' }, element('summary', {}, 'Refused by the board ', count), table);
}
