// What happened, as marks on lanes over time.
//
//   const marks = [...entryMarks(events), ...goalMarks(goals, states, now), ...refusalMarks(refusals)];
//   for (const { marks, from, until } of gathered(marks, 0.5e6)) ...     what lies too close to be told apart

import { fact } from './live_answers.js';
import { text, write } from './datum.js';

/** @import { Answer, Datum, Lasting } from './messages' */
/** Times are in microseconds.
 * @typedef {{ lane: string, from: number, until: number, kind: string, label: string, answer: Answer }} Mark
 * @typedef {Pick<Mark, 'lane' | 'from' | 'until' | 'kind'> & { marks: Mark[] }} Group
 */

export const lanes = ['Goals', 'Plans', 'Operations', 'Servo', 'Sightings', 'Differences', 'Refusals', 'Faults'];
const servoStates = ['up', 'align x', 'align depth', 'approach', 'fine'];
/** @type {Record<string, string>} */
const laneOf = { plan: 'Plans', operation: 'Operations', servo: 'Servo', difference: 'Differences', missing: 'Differences', agent: 'Faults' };
const endsOperation = new Set(['operation', 'plan', 'result', 'goal']);

/** @param {Answer} answer */
const told = (answer) => answer.facts[0].when;
/** @param {Datum} detail */
const failed = (detail) => Array.isArray(detail) && text(detail[0]) === 'fail';

// Of the story, in its order. An operation lasts until something else is begun; goals are drawn by their own facts.
/** @param {Answer[]} events @returns {Mark[]} */
export function entryMarks(events) {
  const read = events.map((answer) => ({ answer, event: fact(answer), when: told(answer) }));
  return read.flatMap(({ answer, event: [, , kind, sentence, detail], when }, i) => {
    const wrong = failed(detail);
    const lane = wrong ? 'Faults' : laneOf[text(kind)];
    if (!lane) return [];
    const lasts = lane === 'Operations' && read.slice(i + 1).find(({ event }) => endsOperation.has(text(event[2])));
    return [{ lane, from: when, until: lasts ? lasts.when : when, kind: wrong ? 'bad' : text(kind), label: text(sentence), answer }];
  });
}

// From when each was wanted until its state is of; one that is pursued lasts until now.
/** @param {Answer[]} goals @param {Answer[]} states @param {number} now @returns {Mark[]} */
export function goalMarks(goals, states, now) {
  const stateOf = new Map(states.map((answer) => [fact(answer)[1], answer]));
  return goals.flatMap((answer) => {
    const [, number, facts] = fact(answer);
    const state = stateOf.get(number);
    const name = state ? text(fact(state)[2]) : 'asked for';
    const label = `goal ${number} ${name}: ${facts.map(write).join(' ')}`;
    const until = state && name !== 'running' ? told(state) : now;
    const goal = { lane: 'Goals', from: told(answer), until, kind: name, label, answer: state ?? answer };
    return name === 'refused' ? [goal, { ...goal, lane: 'Refusals', from: until, kind: 'bad' }] : [goal];
  });
}

// The newest of each kind: what the board refused, and whom.
/** @param {Answer[]} refusals @returns {Mark[]} */
export function refusalMarks(refusals) {
  return refusals.map((answer) => {
    const [, client, symbol, count, sentence] = fact(answer);
    const label = `${text(client)}: ${text(symbol)}, ${count} times: ${text(sentence)}`;
    return { lane: 'Refusals', from: told(answer), until: told(answer), kind: 'bad', label, answer };
  });
}

// Where an object came into sight, or went out of it.
/** @param {Lasting[]} changes @returns {Mark[]} */
export function sightingMarks(changes) {
  return changes.map(({ answer }) => {
    const [, eyes, name, state, frame] = fact(answer);
    const label = `${text(eyes)}: ${text(name)} ${text(state)} since frame ${frame}`;
    return { lane: 'Sightings', from: told(answer), until: told(answer), kind: text(state), label, answer };
  });
}

// The states of the visual servo, for as long as each lasted.
/** @param {Lasting[]} changes @returns {Mark[]} */
export function servoMarks(changes) {
  return changes.map(({ answer, until }) => {
    const [, state, object] = fact(answer);
    const label = `servo ${servoStates[state] ?? state}: ${text(object)}`;
    return { lane: 'Servo', from: told(answer), until, kind: `state-${state}`, label, answer };
  });
}

// Marks of one lane and kind that begin within `close` of one another are one, so that a lane never holds more than its
// width can show.
/** @param {Mark[]} marks @param {number} close */
export function gathered(marks, close) {
  /** @type {Group[]} */
  const groups = [];
  /** @type {Map<string, Group>} */
  const newest = new Map();
  for (const mark of marks.toSorted((a, b) => a.from - b.from)) {
    const key = `${mark.lane} ${mark.kind}`;
    const group = newest.get(key);
    if (group && mark.from - group.from < close) {
      group.marks.push(mark);
      group.until = Math.max(group.until, mark.until);
    } else {
      const begun = { lane: mark.lane, kind: mark.kind, from: mark.from, until: mark.until, marks: [mark] };
      newest.set(key, begun);
      groups.push(begun);
    }
  }
  return groups;
}
