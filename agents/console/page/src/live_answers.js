// What holds of one question: every answer under its facts' ids, as they were told.

import { read } from './datum.js';

/** @import { Answer, Change } from './messages' */
/** Told all that holds, and what has changed of it.
 * @typedef {(answers: Answer[], change: Change) => void} Listener */

export class LiveAnswers {
  /** @type {Map<string, Answer>} */
  #answers = new Map();
  #listener;

  /** @param {Listener} listener */
  constructor(listener) {
    this.#listener = listener;
  }

  /** @param {Change} message */
  change(message) {
    if (message.resynchronised) this.#answers.clear();
    for (const ids of message.removed) this.#answers.delete(ids.join());
    for (const answer of message.added) this.#answers.set(answer.ids.join(), answer);
    this.#listener([...this.#answers.values()], message);
  }
}

// The first fact of an answer, read once.
/** @param {Answer} answer */
export function fact(answer) {
  answer.read ??= read(answer.facts[0].text);
  return answer.read;
}
