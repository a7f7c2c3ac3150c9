// What the console tells a page that asked for it, beside the facts: the simulated world's truth, what goes on on the
// board, and what went on before.
//
//   feeds.layTruth((truth, why) => ...)      null ends it

import { read, sym } from './datum.js';

/** @import { Activity, Fed, Form, Lasting } from './messages' */
/** @import { Line } from './questions.js' */
/** What is told of the truth and of what goes on, or null and why that is not known; and what went on before.
 * @typedef {(truth: Form | null, why?: string) => void} ShowTruth
 * @typedef {(sample: Activity | null, why?: string) => void} ShowActivity
 * @typedef {(kind: 'servo' | 'sightings', changes: Lasting[]) => void} ShowWork
 */

export class Feeds {
  #line;
  /** @type {ShowTruth | null} */
  #truth = null;
  /** @type {ShowActivity | null} */
  #activity = null;
  /** @type {ShowWork | null} */
  #work = null;

  /** @param {Line} line */
  constructor(line) {
    this.#line = line;
  }

  open() {
    if (this.#truth) this.#line.say(sym('truth'));
    if (this.#activity) this.#line.say(sym('activity'));
    if (this.#work) this.#line.say(sym('work'), this.#line.number());
  }
  /** @param {Fed} message */
  hear(message) {
    if ('truth' in message) this.#truth?.(message.truth === null ? null : read(message.truth), message.said);
    else if ('activity' in message) this.#activity?.(message.activity, message.said);
    else this.#work?.(message.work, message.changes);
  }

  // Five times a second, until it ends.
  /** @param {ShowTruth | null} show */
  layTruth(show) {
    this.#truth = show;
    this.#line.say(sym(show ? 'truth' : 'truth-no-more'));
  }
  // Once a second, until it ends.
  /** @param {ShowActivity | null} show */
  sampleActivity(show) {
    this.#activity = show;
    this.#line.say(sym(show ? 'activity' : 'activity-no-more'));
  }
  // Some at a time, and anew with each connection: `show('servo', changes)`, `show('sightings', changes)`.
  /** @param {ShowWork} show */
  earlierWork(show) {
    this.#work = show;
    this.#line.say(sym('work'), this.#line.number());
  }
}
