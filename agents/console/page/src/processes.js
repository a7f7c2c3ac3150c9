// The processes that `up` keeps running on each host: whether they run, how often they were started again, and what
// happened to them last.

import { element } from './dom.js';
import { fact } from './live_answers.js';
import { table } from './tables.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */

/** @param {Connection} connection @param {() => void} changed */
export function showProcesses(connection, changed) {
  const processes = table({ id: 'processes' }, ['Process', 'Host', 'Restarts', 'The last of it']);
  const count = element('span', { class: 'quiet' }, '0');
  /** @type {Map<string, number>} */
  const restarts = new Map();
  connection.follow('(process ?host ?name ?running ?restarts ?newest)', (answers) => {
    const told = answers.map(fact).sort((a, b) => text(a[2]).localeCompare(text(b[2])));
    restarts.clear();
    for (const [, , name, , times] of told) restarts.set(text(name), times);
    count.textContent = String(told.length);
    processes.fill(
      told.map(([, host, name, running, times, newest]) => [
        text(name),
        text(host),
        times,
        text(running) === 'yes' ? text(newest) : element('span', { class: 'chip bad' }, text(newest)),
      ]),
    );
    changed();
  });
  const panel = element('details', { class: 'goals' }, element('summary', {}, 'Processes and their restarts ', count), processes.panel);
  return { panel, restarts };
}
