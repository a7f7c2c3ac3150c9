// By what an operation of the story was ordered: the goal, the plan and its step, by the entries before it.
//
//   orderAt(events, 7)       { goal: 1, operations: [...], step: 2 }, of entry 7 or of the operation in hand then; or null

import { fact } from './live_answers.js';
import { planIn } from './plan_change.js';
import { text, write } from './datum.js';

/** @import { Answer, Datum } from './messages' */

/** @typedef {{ goal: Datum, operations: Datum[], step: number }} Order `step` counts from 0 */

/** @param {Answer[]} events @param {number} number @returns {Order | null} */
export function orderAt(events, number) {
  const earlier = events.map(fact).filter((event) => event[1] <= number);
  // One that failed is told of once more; what it was is said by the entry with which it began.
  const begun = earlier.findLast(([, , kind, sentence]) => text(kind) === 'operation' && /^operation \d+:/.test(text(sentence)));
  if (!begun) return null;
  const step = Number(text(begun[3]).match(/\d+/)?.[0]) - 1;
  const plans = earlier.filter((event) => event[1] < begun[1]).map((event) => planIn(event[4]));
  const plan = plans.findLast((one) => one && one.operations[step] !== undefined && write(one.operations[step]) === write(begun[4]));
  return plan ? { ...plan, step } : null;
}
