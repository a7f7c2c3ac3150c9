// SAVE and GOTO, with the names of what was saved.

import { element } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { CommandLog } from './command_log.js' */
/** @import { Connection } from './connection.js' */
/** @import { Hands } from './hands.js' */

/** @param {Connection} connection @param {Hands} hands @param {CommandLog} log */
export function placesForm(connection, hands, log) {
  const known = element('datalist', { id: 'variables' });
  const name = element('input', {
    id: 'variable',
    list: 'variables',
    maxlength: 32,
    size: 12,
    spellcheck: 'false',
    placeholder: 'p1',
    'aria-label': 'Name of a place',
    pattern: '[a-z][a-z0-9\\-]*',
    title: 'a letter, then letters, digits and hyphens',
  });
  /** @param {string} operation */
  const send = (operation) => () => name.value && name.reportValidity() && log.send(`(${operation} ${name.value})`);
  const save = element('button', { type: 'button', onclick: send('learn') }, 'Save');
  const go = element('button', { type: 'button', onclick: send('goto') }, 'Go to');
  connection.follow('(robot-variable ?robot ?name ?joints)', (answers) => {
    const names = answers.map(fact).filter((saved) => text(saved[1]) === hands.robot);
    known.replaceChildren(...names.map((saved) => element('option', { value: text(saved[2]) })));
  });
  return { parts: [name, known, save, go], name, save, go };
}
