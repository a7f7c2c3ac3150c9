// What goes on on the board, once a second, as `top` has it: taken while one of the parts that show it is on the screen.
//
//   const activity = new Activity(connection);
//   activity.shownIn(panel, (sample, why) => ...);        // null and why, where it cannot be had

/** @import { Connection } from './connection.js' */
/** @import { ShowActivity } from './feeds.js' */

export class Activity {
  #connection;
  /** @type {Map<Element, boolean>} */
  #parts = new Map(); // whether each is on the screen
  /** @type {ShowActivity[]} */
  #listeners = [];
  #on = false;

  /** @param {Connection} connection */
  constructor(connection) {
    this.#connection = connection;
  }

  /** @param {Element} panel @param {ShowActivity} listener */
  shownIn(panel, listener) {
    this.#listeners.push(listener);
    this.#parts.set(panel, false);
    new IntersectionObserver((entries) => {
      this.#parts.set(panel, entries[entries.length - 1].isIntersecting);
      this.#choose();
    }).observe(panel);
  }

  #choose() {
    const on = [...this.#parts.values()].includes(true);
    if (on === this.#on) return;
    this.#on = on;
    /** @type {ShowActivity} */
    const tell = (sample, why) => this.#listeners.forEach((listener) => listener(sample, why));
    this.#connection.sampleActivity(on ? tell : null);
  }
}
