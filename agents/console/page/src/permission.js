// Whether this page may command now, and why not: there is no live line, its key has no right to it, or it shows a moment
// that has gone by. The board decides, whatever the page believes; this says it before anybody presses.
//
//   permission.line, permission.past                a reason, or '' where there is none
//   permission.right('jog', 'request')              of a key that may not say one of these words (hello's `mayNot`)
//   permission.command('request')                   the first reason of them all
//   permission.onChange(() => ...)

/** @import { Hello } from './messages' */

export class Permission {
  #live = false;
  #past = false;
  /** @type {Hello['mayNot']} */
  #mayNot = {};
  /** @type {(() => void)[]} */
  #listeners = [];

  /** @param {{ live?: boolean, past?: boolean, mayNot?: Hello['mayNot'] }} now */
  set({ live = this.#live, past = this.#past, mayNot = this.#mayNot }) {
    this.#live = live;
    this.#past = past;
    this.#mayNot = mayNot;
    for (const listener of this.#listeners) listener();
  }
  // It is told at once, too.
  /** @param {() => void} listener */
  onChange(listener) {
    this.#listeners.push(listener);
    listener();
  }

  get live() {
    return this.#live;
  }
  get line() {
    return this.#live ? '' : 'There is no live line to the console';
  }
  get past() {
    return this.#past ? 'You look at the past: press Now first' : '';
  }
  /** @param {string[]} words */
  right(...words) {
    return words.map((word) => this.#mayNot[word]).find(Boolean) ?? '';
  }
  /** @param {string[]} words */
  command(...words) {
    return this.line || this.right(...words) || this.past;
  }
}
