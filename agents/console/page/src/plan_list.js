// The plan as a list: the operation in hand, what is done or was skipped, and what still serves.

import { clipped, eachFrame, element, find } from './dom.js';
import { fact } from './live_answers.js';
import { planStates } from './plan_states.js';
import { write } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { WorkEntries } from './work_entries.js' */
/** @import { Answer, Datum, Form } from './messages' */

// What is worth a second look in the list.
/** @type {Record<string, string>} */
const classOf = { 'still serves': 'serves' };

/** @param {Form | undefined} plan @param {string[]} states */
function list(plan, states) {
  const shown = find('plan');
  shown.replaceChildren();
  find('plan-note').textContent = plan ? `for goal ${plan[1]}` : 'none yet';
  if (!plan) return;
  plan[2].forEach((/** @type {Datum} */ operation, /** @type {number} */ index) => {
    const state = states[index];
    const item = element('li', { class: classOf[state] ?? state }, element('code', {}, clipped(write(operation), 80)));
    if (state) item.append(element('span', { class: 'mark' }, state));
    if (state === 'running') item.setAttribute('aria-current', 'step');
    shown.append(item);
  });
  // In its own list alone: the page stays where it is.
  const current = shown.querySelector('.running');
  if (current instanceof HTMLElement) shown.scrollTop = current.offsetTop - shown.offsetTop - shown.clientHeight / 2;
}

/** @param {Connection} connection @param {WorkEntries} entries */
export function showPlan(connection, entries) {
  /** @type {Form | undefined} */
  let plan;
  /** @type {Answer | undefined} */
  let inHand;
  const show = eachFrame(() => {
    const events = entries.until(connection.moment ?? Infinity);
    list(plan, plan ? planStates(plan, inHand, events) : []);
  });
  entries.onChange(show);
  connection.follow('(plan ?n ?operations)', (answers) => {
    plan = answers.length ? fact(answers[0]) : undefined;
    show();
  });
  connection.follow('(operation ?i ?operation ?state)', (answers) => {
    inHand = answers[0];
    show();
  });
}
