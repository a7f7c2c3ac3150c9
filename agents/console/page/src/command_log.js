// What an agent was told to do, newest first: by this page, with the answer, and by others.

import { clipped, clock, element, failureText } from './dom.js';
import { fact } from './live_answers.js';
import { nameOf } from './names.js';
import { read, text, write } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer } from './messages' */

const shown = 60;

export class CommandLog {
  #connection;
  #agent; // answers the agent's name
  #me;
  list;

  /** @param {Connection} connection @param {() => string} agent @param {() => string} me @param {string} label */
  constructor(connection, agent, me, label) {
    this.#connection = connection;
    this.#agent = agent;
    this.#me = me;
    this.list = element('ol', { class: 'log', 'aria-label': label });
    connection.followAlways('(request ?id ?agent ?operation)', (_, message) => this.#received(message.added));
  }

  /** @param {string} who @param {string} command */
  #add(who, command) {
    const answer = element('span', {});
    const item = element(
      'li',
      {},
      element('time', {}, clock(Date.now() * 1000)),
      element('span', { class: 'quiet' }, `${clipped(who, 40)} `),
      element('code', {}, clipped(command, 200)),
      answer,
    );
    this.list.prepend(item);
    while (this.list.children.length > shown) this.list.lastChild?.remove();
    return { item, answer };
  }

  /** @param {Answer[]} added */
  #received(added) {
    for (const answer of added) {
      const { teller } = answer.facts[0];
      const [, , agent, operation] = fact(answer);
      if (text(agent) === this.#agent() && teller !== this.#me()) this.#add(nameOf(teller, this.#me()), write(operation));
    }
  }

  // Writes how it ended behind it; throws nothing. `begun` is the promise of the answer's values.
  /** @param {string} command @param {Promise<string[]>} begun */
  async follow(command, begun) {
    const { item, answer } = this.#add('you', command);
    answer.textContent = ' …';
    try {
      answer.textContent = ` ${clipped((await begun).join(' ') || 'ok', 200)}`;
    } catch (failure) {
      answer.textContent = ` ${failureText(failure)}`;
      item.className = 'bad';
    }
  }

  /** @param {string} form */
  send(form) {
    return this.follow(form, this.#connection.request(this.#agent(), read(form)));
  }
}
