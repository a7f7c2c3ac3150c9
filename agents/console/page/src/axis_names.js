// The axes of the arms by name and unit, as the console knows them of the arms' files.
//
//   axes.set(hello.axes);
//   axes.words('robot', [0, 20, 2500])        [['turn', '0.0 °'], ['shoulder', '20.0 °'], ['track', '2500.0 mm']]
//   axes.onChange(() => ...)

import { fixed } from './dom.js';

/** @import { Hello } from './messages' */

export class Axes {
  /** @type {Hello['axes']} */
  #axes = {};
  /** @type {(() => void)[]} */
  #listeners = [];

  /** @param {Hello['axes']} axes */
  set(axes) {
    this.#axes = axes;
    for (const listener of this.#listeners) listener();
  }
  /** @param {() => void} listener */
  onChange(listener) {
    this.#listeners.push(listener);
  }

  // Those of an arm that the console does not know have numbers.
  /** @param {string} robot @param {number[]} joints @param {number} digits @returns {[name: string, value: string][]} */
  words(robot, joints, digits = 1) {
    const known = this.#axes[robot] ?? [];
    return joints.map((value, i) => {
      const [name, unit] = known[i] ?? [`axis ${i + 1}`, ''];
      return [name, `${fixed(value, digits)} ${unit}`.trim()];
    });
  }
}
