// Operations of the eyes, and the panel that shows their replies. A reply that says FAIL has three values: its text, the
// reason as a symbol, and as a sentence. The sentence stands below the text.
//
//   const requests = new EyesRequests(connection);
//   requests.eyes = 'vision-2';                              whom the next one goes to
//   await requests.values(sym('learn'), ...)                 the reply's values; throws a failure
//   requests.button('Find', sym('find'), 'circle')           a button that shows the reply

import { clipped, element, failureText } from './dom.js';

/** @import { Connection } from './connection.js' */
/** @import { Datum } from './messages' */

// Of a reply that says FAIL.
/** @param {string[]} values */
export const whyFailed = (values) => values[2] ?? 'no reason was told';

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
      const shown = / FAIL\)/.test(values[0] ?? '') ? [values[0], whyFailed(values)] : values;
      this.panel.textContent = clipped(shown.join('\n') || 'ok', 2000);
    } catch (failure) {
      this.panel.textContent = failureText(failure);
    }
  }
}
