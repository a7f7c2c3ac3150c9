// What the page wants done: each request is answered, or throws a failure.
//
//   await requests.call('stop', 'the operator pressed it')       the reply's values
//   requests.callWith(ended, 'goal', '(on a b)')                 `ended` hears the reply that comes after the first

import { sym } from './datum.js';

/** @import { Datum, Failure, Reply } from './messages' */
/** @import { Line } from './questions.js' */
/** @typedef {{ reject: (failure: Failure) => void, take: (reply: Reply) => void }} Request */

// The connection ended meanwhile.
export const gone = { symbol: 'unreachable', sentence: 'the console has gone; whether it was done is not known' };

export class Requests {
  #line;
  /** @type {Map<number, Request>} */
  #open = new Map();

  /** @param {Line} line */
  constructor(line) {
    this.#line = line;
  }

  lost() {
    for (const { reject } of this.#open.values()) reject(gone);
    this.#open.clear();
  }
  /** @param {number} number @param {Reply} reply */
  hear(number, reply) {
    this.#open.get(number)?.take(reply);
  }

  /** @param {string} verb @param {Datum[]} rest */
  call(verb, ...rest) {
    return this.callAs(this.#line.number(), null, verb, ...rest);
  }
  /** @param {(reply: Reply) => void} more @param {string} verb @param {Datum[]} rest */
  callWith(more, verb, ...rest) {
    return this.callAs(this.#line.number(), more, verb, ...rest);
  }
  /** @param {number} number @param {((reply: Reply) => void) | null} more @param {string} verb @param {Datum[]} rest @returns {Promise<any[]>} */
  callAs(number, more, verb, ...rest) {
    return new Promise((resolve, reject) => {
      /** @param {Reply} message */
      const take = (message) => {
        if (more && !('error' in message)) this.#open.set(number, { reject: () => {}, take: (later) => this.#end(number, more, later) });
        else this.#open.delete(number);
        if ('error' in message) reject(message.error);
        else resolve(message.values);
      };
      this.#open.set(number, { reject, take });
      if (this.#line.say(sym(verb), number, ...rest)) return;
      this.#open.delete(number);
      reject(this.#line.notConnected);
    });
  }
  /** @param {number} number @param {(reply: Reply) => void} more @param {Reply} message */
  #end(number, more, message) {
    this.#open.delete(number);
    more(message);
  }
}
