// In whose hands the arm is: the commander fact, which its agent obeys.

import { confirmed } from './confirm.js';
import { find } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

export class Hands {
  #connection;
  #listeners = [];
  #holders = [];
  me = '';
  robot = 'robot';

  constructor(connection) {
    this.#connection = connection;
    connection.followAlways('(commander ?robot ?client)', (answers) => {
      this.#holders = answers.map(fact);
      this.changed();
    });
  }

  get holder() {
    const first = this.#holders.find((held) => text(held[1]) === this.robot);
    return first ? text(first[2]) : '';
  }
  get mine() {
    return this.me !== '' && this.holder === this.me;
  }

  onChange(listener) {
    this.#listeners.push(listener);
    listener(this.mine, this.holder);
  }
  changed() {
    const chip = find('arm-chip');
    chip.hidden = this.holder === '';
    chip.textContent = this.mine ? 'arm: in your hands' : `arm: ${this.holder}`;
    chip.className = this.mine ? 'chip good' : 'chip warn';
    for (const listener of this.#listeners) listener(this.mine, this.holder);
  }

  // Takes it, lets it go, or takes it over from another who is asked about first.
  async toggle() {
    if (this.mine) return this.#connection.hold('let-go', this.robot);
    if (this.holder === '') return this.#connection.hold('command', this.robot);
    const sure = await confirmed(`${this.holder} has the arm in hand. Take it over? Its motion ends.`);
    return sure ? this.#connection.hold('take-over', this.robot) : undefined;
  }
}
