// In whose hands the arm is: the commander fact, which its agent obeys; and who asks for it.

import { confirmed } from './confirm.js';
import { find } from './dom.js';
import { fact } from './live_answers.js';
import { nameOf } from './names.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Permission } from './permission.js' */
/** @import { Form } from './messages' */

export class Hands {
  #connection;
  #permission;
  /** @type {((mine: boolean, holder: string) => void)[]} */
  #listeners = [];
  /** @type {Form[]} */
  #holders = [];
  /** @type {Form[]} */
  #wishes = [];
  #before = ''; // who had it
  #had = false; // whether that was this page, under whatever name
  #lettingGo = false;
  #taking = false;
  /** @type {{ from: string, to: string } | null} */
  change = null; // of hands, into this page's or out of them, until it is read
  me = '';
  robot = 'robot';

  /** @param {Connection} connection @param {Permission} permission */
  constructor(connection, permission) {
    this.#connection = connection;
    this.#permission = permission;
    connection.followAlways('(commander ?robot ?client)', (answers) => {
      this.#holders = answers.map(fact);
      this.#note();
      this.changed();
    });
    connection.followAlways('(commander-wanted ?robot ?client)', (answers) => {
      this.#wishes = answers.map(fact);
      this.changed();
    });
    permission.onChange(() => this.changed());
  }

  get holder() {
    const first = this.#holders.find((held) => text(held[1]) === this.robot);
    return first ? text(first[2]) : '';
  }
  get mine() {
    return this.#permission.live && this.me !== '' && this.holder === this.me;
  }
  // Why this page may not take the arm, and why what needs it in hand is off; '' where it may.
  get whyNotTaken() {
    return this.#permission.line || this.#permission.right('command');
  }
  get why() {
    return this.whyNotTaken || this.#permission.command('request') || (this.mine ? '' : 'Take the arm in hand first');
  }
  // In words.
  get holderName() {
    return nameOf(this.holder, this.me);
  }
  // Who asks for it, and whether this page does.
  get askers() {
    const here = this.#wishes.filter((wish) => text(wish[1]) === this.robot).map((wish) => text(wish[2]));
    return here.filter((client) => client !== this.me).map((client) => nameOf(client, this.me));
  }
  get asking() {
    return this.#wishes.some((wish) => text(wish[1]) === this.robot && text(wish[2]) === this.me);
  }

  // From one's hands into another's: both are told. Who loses it without letting it go is told so, too.
  #note() {
    const from = this.#before;
    const had = this.#had;
    const to = this.holder;
    this.#before = to;
    this.#had = to !== '' && to === this.me;
    if (from === to) return;
    const change = { from: nameOf(from, this.me), to: nameOf(to, this.me) };
    if (this.#had) this.change = from ? change : null;
    else if (had && !this.#lettingGo) this.change = change;
    this.#lettingGo = false;
  }

  /** @param {(mine: boolean, holder: string) => void} listener */
  onChange(listener) {
    this.#listeners.push(listener);
    listener(this.mine, this.holder);
  }
  changed() {
    const chip = find('arm-chip');
    chip.hidden = this.holder === '';
    chip.textContent = this.mine ? 'arm: in your hands' : `arm: ${this.#permission.live ? this.holderName : 'not known'}`;
    chip.className = this.mine ? 'chip good' : 'chip warn';
    for (const listener of this.#listeners) listener(this.mine, this.holder);
    this.#followWish();
  }

  // Who asked takes it as soon as it is free, and asks no more.
  async #followWish() {
    if (!this.#permission.live || !this.asking || this.#taking || !(this.mine || this.holder === '')) return;
    this.#taking = true;
    const verb = this.mine ? 'ask-no-more' : 'command';
    await this.#connection.hold(verb, this.robot).catch(() => {}); // another was quicker
    this.#taking = false;
    if (this.mine) this.#followWish();
  }

  // Takes it, lets it go, or takes it over from another who is asked about first.
  async toggle() {
    if (this.mine) return this.#letGo();
    if (this.holder === '') return this.#connection.hold('command', this.robot);
    const sure = await confirmed(`${this.holderName} has the arm in hand. Take it over? Its motion ends.`);
    return sure ? this.#connection.hold('take-over', this.robot) : undefined;
  }
  async #letGo() {
    this.#lettingGo = true;
    try {
      await this.#connection.hold('let-go', this.robot);
    } catch (failure) {
      this.#lettingGo = false;
      throw failure;
    }
  }
  toggleWish() {
    return this.#connection.hold(this.asking ? 'ask-no-more' : 'ask-for', this.robot);
  }
}
