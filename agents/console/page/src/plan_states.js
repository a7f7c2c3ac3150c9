// How far a plan has come: for each of its operations '', 'done', 'skipped', 'still serves', or the state that it has in
// hand. The operation in hand says where the plan stands; the story says what of it was begun, what somebody else did,
// and from where on it still served after a difference.

import { fact } from './live_answers.js';
import { planIn } from './plan_change.js';
import { text, write } from './datum.js';

/** @import { Answer, Datum, Form } from './messages' */

/** @param {string[]} plan @param {string[]} rest */
const endsAlike = (plan, rest) => rest.every((operation, i) => operation === plan[plan.length - rest.length + i]);

// What was told since the plan was made: from the newest entry that names the whole of it.
/** @param {Datum} goal @param {string[]} plan @param {Form[]} events */
function sinceMade(goal, plan, events) {
  const made = events.findLastIndex((event) => {
    const told = planIn(event[4]);
    return told !== null && told.goal === goal && told.operations.map(write).join() === plan.join();
  });
  return events.slice(made + 1);
}

/** @param {Form} planFact @param {Answer | undefined} operationAnswer @param {Answer[]} answers @returns {string[]} */
export function planStates(planFact, operationAnswer, answers) {
  const [, goal, operations] = planFact;
  /** @type {string[]} */
  const plan = operations.map(write);
  /** @type {Set<string>} */
  const begun = new Set();
  /** @type {Set<string>} */
  const skipped = new Set();
  let servesFrom = Infinity;
  for (const [, , kind, , detail] of sinceMade(goal, plan, answers.map(fact))) {
    const rest = planIn(detail)?.operations.map(write);
    if (text(kind) === 'operation') begun.add(write(detail));
    else if (rest && rest.length < plan.length && endsAlike(plan, rest)) {
      servesFrom = plan.length - rest.length;
      for (const again of plan.slice(servesFrom)) for (const those of [begun, skipped]) those.delete(again);
    } else if (text(kind) === 'difference' && Array.isArray(detail)) {
      for (const operation of detail.map(write)) if (plan.includes(operation)) skipped.add(operation);
    }
  }
  const inHand = operationAnswer && fact(operationAnswer);
  const stands = inHand && write(inHand[2]) === plan[inHand[1]];
  return plan.map((operation, i) => {
    if (stands && i === inHand[1]) return text(inHand[3]);
    if (stands && i < inHand[1]) return skipped.has(operation) ? 'skipped' : 'done';
    if (skipped.has(operation)) return 'skipped';
    return i >= servesFrom ? 'still serves' : '';
  });
}
