// Why an entry of the story came about: what the operation in hand was ordered by, what was expected before and after it,
// and what was believed at that moment, as the journal has it.

import { clipped, element } from './dom.js';
import { fact } from './live_answers.js';
import { orderAt } from './order.js';
import { sym, text, write } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Order } from './order.js' */
/** @import { Answer, Datum } from './messages' */

/** What must hold before and after the operation; null where nobody knows.
 * @typedef {{ before: Datum[], after: Datum[] } | null} Expected */

// `then` is false where no journal can say it.
/** @param {Connection} connection @param {string} query @param {number} when */
async function heldThen(connection, query, when) {
  try {
    return { answers: await connection.askThen(query, when), then: true };
  } catch {
    return { answers: [], then: false };
  }
}

/** @param {Connection} connection @param {Order} order @param {number} when @returns {Promise<Expected>} */
async function expectedBy(connection, { goal, operations, step }, when) {
  const query = [sym('plan-needs'), sym('?n'), sym('?needs')];
  const { answers, then } = await heldThen(connection, write(query), when);
  const [needs] = (then ? answers : await connection.ask(query)).map(fact);
  // Those of another plan say nothing.
  if (!needs || needs[1] !== goal || needs[2].length !== operations.length + 1) return null;
  return { before: needs[2][step], after: needs[2][step + 1] };
}

/** @param {Datum} wanted @param {Set<string>} believed */
const holdsIn = (wanted, believed) =>
  Array.isArray(wanted) && text(wanted[0]) === 'not' ? !believed.has(write(wanted[1])) : believed.has(write(wanted));

// `believed`: against what each of them is held, if against anything.
/** @param {Datum[]} facts @param {Set<string> | null} believed */
function listOf(facts, believed) {
  if (facts.length === 0) return 'nothing';
  const items = facts.map((one) => {
    const holds = believed && holdsIn(one, believed);
    const mark = holds === null ? '' : holds ? ' holds' : ' does not hold';
    return element('li', { class: holds === false ? 'lacks' : '' }, element('code', {}, clipped(write(one), 120)), element('small', { class: 'quiet' }, mark));
  });
  return element('ul', { class: 'expected' }, ...items);
}

/** @param {Order} order */
const planOf = ({ operations, step }) =>
  element(
    'ol',
    { class: 'ordered' },
    ...operations.map((operation, i) =>
      element('li', { 'aria-current': i === step ? 'step' : null }, element('code', {}, clipped(write(operation), 120))),
    ),
  );

/** @param {[label: string, value: Node | string][]} rows */
const table = (rows) => element('dl', { class: 'why' }, ...rows.flatMap(([label, value]) => [element('dt', {}, label), element('dd', {}, value)]));

/** @param {Connection} connection @param {Answer[]} events @param {Answer} answer @returns {Promise<Node | string>} */
export async function entryWhy(connection, events, answer) {
  const [, number, kind] = fact(answer);
  const { when } = answer.facts[0];
  const order = orderAt(events, number);
  if (!order || !['operation', 'servo', 'difference', 'missing'].includes(text(kind))) return '';
  const [goal] = (await connection.ask([sym('goal'), order.goal, sym('?facts')])).map(fact);
  const then = await heldThen(connection, '(believed ?fact)', when);
  const believed = then.answers.map((one) => fact(one)[1]);
  const known = then.then ? new Set(believed.map(write)) : null;
  const expected = await expectedBy(connection, order, when);
  const unknown = 'not known: the plan is not there any more, and no journal has it';
  return table([
    ['Ordered by', `goal ${write(order.goal)}${goal ? `: ${clipped(goal[2].map(write).join(' '), 300)}` : ''}`],
    [`Step ${order.step + 1} of ${order.operations.length}`, planOf(order)],
    ['Expected before', expected ? listOf(expected.before, known) : unknown],
    ['Expected after', expected ? listOf(expected.after, null) : unknown],
    ['Believed then', known ? listOf(believed, null) : 'not known: this board keeps no journal'],
  ]);
}
