// Who plays the console's roles, as the console tells it: `(wire console eyes vision-2)` changes it while the page is
// open.
//
//   const roles = new Roles(connection);
//   roles.server('robot')                                      '' where nobody plays it
//   roles.follow('eyes', '(look ?eyes ? ? ?)', (facts) => ...) those that this agent tells; all where nobody plays it
//   roles.onChange(() => ...)

import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Form } from './messages' */

export class Roles {
  #connection;
  /** @type {Map<string, string>} */
  #servers = new Map();
  /** @type {(() => void)[]} */
  #listeners = [];

  /** @param {Connection} connection */
  constructor(connection) {
    this.#connection = connection;
    connection.followAlways('(holder console ?role ?server ?state)', (answers) => {
      const present = answers.map(fact).filter(([, , , , state]) => text(state) !== 'absent');
      this.#servers = new Map(present.map(([, , role, server]) => [text(role), text(server)]));
      for (const listener of this.#listeners) listener();
    });
  }

  /** @param {string} role */
  server(role) {
    return this.#servers.get(role) ?? '';
  }
  /** @param {string} role @param {string} query @param {(facts: Form[]) => void} listener */
  follow(role, query, listener) {
    /** @type {Form[]} */
    let facts = [];
    const tell = () => {
      const server = this.server(role);
      listener(server === '' ? facts : facts.filter((one) => text(one[1]) === server));
    };
    this.#connection.follow(query, (answers) => {
      facts = answers.map(fact);
      tell();
    });
    this.onChange(tell);
  }
  /** @param {() => void} listener */
  onChange(listener) {
    this.#listeners.push(listener);
  }
}
