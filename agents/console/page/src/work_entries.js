// The story as far back as is asked for. The board holds its newest entries alone; what stood before them is read from
// the journal, piece by piece, where the board keeps one.

import { fact } from './live_answers.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer } from './messages' */

const query = '(event ?n ?kind ?sentence ?detail)';
const most = 5000;

/** @param {Answer} answer */
const whenTold = (answer) => answer.facts[0].when;

// What an entry is known by: a board that began anew counts anew.
/** @param {Answer} answer */
export const keyOf = (answer) => `${fact(answer)[1]}@${whenTold(answer)}`;

export class WorkEntries {
  #connection;
  /** @type {Map<string, Answer>} */
  #known = new Map();
  #reading = false;
  #exhausted = false;
  /** @type {(() => void)[]} */
  #listeners = [];

  /** @param {Connection} connection */
  constructor(connection) {
    this.#connection = connection;
    connection.follow(query, (answers) => {
      this.#add(answers);
      this.#changed();
    });
  }

  /** @param {() => void} listener */
  onChange(listener) {
    this.#listeners.push(listener);
  }
  #changed() {
    for (const listener of this.#listeners) listener();
  }

  // In their order, those that were told until that time.
  /** @param {number} moment */
  until(moment) {
    const told = [...this.#known.values()].filter((answer) => whenTold(answer) <= moment);
    return told.sort((a, b) => whenTold(a) - whenTold(b) || fact(a)[1] - fact(b)[1]);
  }

  // Reads on into the past until it has that time, or there is no more.
  /** @param {number} moment */
  async reach(moment) {
    if (this.#reading || this.#exhausted) return;
    this.#reading = true;
    while (!this.#exhausted && this.#known.size < most) {
      const oldest = this.until(Infinity)[0];
      if (!oldest || fact(oldest)[1] <= 1 || whenTold(oldest) <= moment) break;
      const before = this.#known.size;
      this.#add(await this.#connection.askThen(query, whenTold(oldest)).catch(() => []));
      this.#exhausted = this.#known.size === before;
      this.#changed();
    }
    this.#reading = false;
  }

  /** @param {Answer[]} answers */
  #add(answers) {
    for (const answer of answers) this.#known.set(keyOf(answer), answer);
    if (this.#known.size <= most) return;
    const oldest = [...this.#known].sort(([, a], [, b]) => whenTold(a) - whenTold(b)).slice(0, this.#known.size - most);
    for (const [key] of oldest) this.#known.delete(key);
  }
}
