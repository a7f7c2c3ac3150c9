// The goals so far and what became of them, newest first.

import { clipped, clock, element } from './dom.js';
import { fact } from './live_answers.js';
import { text, write } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer, Datum } from './messages' */

const shown = 50;
/** @type {Record<string, string>} */
const kinds = { reached: 'good', running: 'busy', kept: 'good' };

// A failure's sentence; '' where it ended without one.
/** @param {Datum} detail */
const reasonIn = (detail) => (Array.isArray(detail) && text(detail[0]) === 'fail' ? text(detail[2]) : '');

/** @param {Connection} connection */
export function goalHistory(connection) {
  const count = element('span', { class: 'quiet' }, '');
  const body = element('tbody', {});
  const heads = ['', 'Goal', 'Outcome', 'Since'].map((name) => element('th', {}, name));
  const table = element('table', { id: 'goals' }, element('thead', {}, element('tr', {}, ...heads)), body);

  /** @type {Map<number, Datum[]>} */
  let wanted = new Map();
  /** @type {Map<number, Answer>} */
  let states = new Map();
  const draw = () => {
    const numbers = [...new Set([...wanted.keys(), ...states.keys()])].sort((a, b) => b - a);
    count.textContent = numbers.length > shown ? `${numbers.length}, ${shown} shown` : String(numbers.length);
    const rows = numbers.slice(0, shown).map((number) => {
      const state = states.get(number);
      const outcome = state ? text(fact(state)[2]) : 'asked for';
      const reason = state ? reasonIn(fact(state)[3]) : '';
      return element(
        'tr',
        {},
        element('td', {}, String(number)),
        element('td', {}, element('code', {}, clipped((wanted.get(number) ?? []).map(write).join(' '), 200))),
        element('td', {}, element('span', { class: `chip ${kinds[outcome] ?? 'warn'}` }, outcome), reason && ` ${clipped(reason)}`),
        element('td', {}, state ? clock(state.facts[0].when) : ''),
      );
    });
    body.replaceChildren(...rows);
  };
  connection.follow('(goal ?n ?facts)', (answers) => {
    wanted = new Map(answers.map(fact).map(([, number, facts]) => [number, facts]));
    draw();
  });
  connection.follow('(goal-state ?n ?state ?detail)', (answers) => {
    states = new Map(answers.map((answer) => [fact(answer)[1], answer]));
    draw();
  });
  return element('details', { class: 'goals' }, element('summary', {}, 'Goals so far ', count), table);
}
