// The states of the servo and how long each lasted, and what came into sight and went: as the console has read and kept
// them, and from then on live.
//
//   const changes = new WorkChanges(connection, changed);
//   changes.servo(until), changes.sightings(until)      [{ answer, until }, ...], told until that time

import { fact } from './live_answers.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer, Lasting } from './messages' */

const most = 4000; // of each kind

/** @typedef {'servo' | 'sightings'} Kind */

/** @param {Lasting} change */
const told = ({ answer }) => answer.facts[0].when;

export class WorkChanges {
  /** @type {Record<Kind, Map<number, Lasting>>} */
  #kept = { servo: new Map(), sightings: new Map() }; // by the number of the first fact of each
  /** @type {Lasting | null} */
  #running = null; // the servo's state
  #changed;

  /** @param {Connection} connection @param {() => void} changed */
  constructor(connection, changed) {
    this.#changed = changed;
    connection.followAlways('(servo ?state ?object ?x ?y ?d)', ([answer]) => this.#servoTold(answer));
    connection.followAlways('(tracked ?eyes ?name ?state ?frame ?confidence)', (answers) => {
      for (const answer of answers) this.#add('sightings', { answer, until: answer.facts[0].when });
      changed();
    });
    connection.earlierWork((kind, changes) => {
      for (const change of changes) this.#add(kind, change);
      changed();
    });
  }

  /** @param {number} until */
  servo(until) {
    return this.#until('servo', until);
  }
  /** @param {number} until */
  sightings(until) {
    return this.#until('sightings', until);
  }
  /** @param {Kind} kind @param {number} until */
  #until(kind, until) {
    return [...this.#kept[kind].values()].filter((change) => told(change) <= until);
  }

  /** @param {Kind} kind @param {Lasting} change */
  #add(kind, change) {
    const kept = this.#kept[kind];
    kept.set(change.answer.ids[0], change);
    if (kept.size <= most) return;
    const oldest = [...kept].reduce((a, b) => (told(b[1]) < told(a[1]) ? b : a));
    kept.delete(oldest[0]);
  }

  /** @param {Answer | undefined} answer */
  #servoTold(answer) {
    /** @param {Answer} of */
    const state = (of) => fact(of).slice(1, 3).join(' ');
    if (answer && this.#running) this.#running.until = answer.facts[0].when;
    if (!answer) this.#running = null;
    else if (!this.#running || state(this.#running.answer) !== state(answer)) {
      this.#running = { answer, until: answer.facts[0].when };
      this.#add('servo', this.#running);
    }
    this.#changed();
  }
}
