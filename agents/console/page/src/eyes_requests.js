// Operations of the eyes, and the panel that shows their replies. Where a reply says FAIL, the reason that the eyes told
// stands below it.
//
//   const requests = new EyesRequests(connection);
//   requests.eyes = 'vision-2';                              whom the next one goes to
//   await requests.values(sym('learn'), ...)                 the reply's values; throws a failure
//   requests.button('Find', sym('find'), 'circle')           a button that shows the reply

import { clipped, element, failureText } from './dom.js';
import { fact } from './live_answers.js';
import { sym, text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Datum } from './messages' */

export class EyesRequests {
  #connection;
  eyes = 'vision';
  panel = element('pre', { class: 'answer', id: 'eyes-answer', role: 'status', hidden: true });

  /** @param {Connection} connection */
  constructor(connection) {
    this.#connection = connection;
  }

  /** @param {Datum[]} operation */
  values(...operation) {
    return this.#connection.request(this.eyes, operation);
  }
  // Why the eyes gave that reply.
  /** @param {string} reply */
  async whyFailed(reply) {
    const query = [sym('vision-failed'), sym(this.eyes), sym('?'), reply, sym('?'), sym('?sentence')];
    const answers = await this.#connection.ask(query);
    return answers.length ? text(fact(answers[0])[5]) : 'no reason was told';
  }
  /** @param {string} label @param {Datum[]} operation */
  button(label, ...operation) {
    return element('button', { type: 'button', onclick: () => this.#show(operation) }, label);
  }

  /** @param {Datum[]} operation */
  async #show(operation) {
    this.panel.hidden = false;
    this.panel.textContent = '…';
    try {
      const values = await this.values(...operation);
      const why = / FAIL\)/.test(values[0] ?? '') ? `\n${await this.whyFailed(values[0])}` : '';
      this.panel.textContent = clipped((values.join('\n') || 'ok') + why, 2000);
    } catch (failure) {
      this.panel.textContent = failureText(failure);
    }
  }
}
