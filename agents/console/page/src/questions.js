// Questions to the board that live on: what holds, and every change; of now, or of the moment that is shown.
//
//   questions.follow('(place ?name ?x ?y ?z ?f)', (answers) => ...)     all that holds, whenever that changes
//   await questions.ask([sym('goal'), sym('?n'), sym('?facts')])        what holds now, once
//   await questions.showMoment(microseconds)                            all that is followed, as it was then

import { LiveAnswers } from './live_answers.js';
import { read, sym, write } from './datum.js';

/** @import { Listener } from './live_answers.js' */
/** @import { Answer, Change, Datum, Failure } from './messages' */
/** A question that lives on, or that is asked `once`. `always` is of now, whatever moment is shown.
 * @typedef {{ query: string, typed?: boolean, once?: boolean, always: boolean, take: (told: Told) => void }} Watched
 * @typedef {Change | { error: Failure }} Told
 * @typedef {{ listeners: Listener[], told: Parameters<Listener> | null }} Shared
 * @typedef {{ say: (...form: Datum[]) => boolean, number: () => number, notConnected: Failure }} Line
 */

const atOnce = 4; // questions of the past

export class Questions {
  #line;
  /** @type {Map<number, Watched>} */
  #watches = new Map();
  /** @type {Map<string, Shared>} */
  #shared = new Map(); // what is followed, by its query
  /** @type {Map<number, (told: Told) => void>} */
  #asked = new Map(); // questions of the past, by their watches
  /** @type {number | null} */
  moment = null; // what is shown is of then, in microseconds; null: of now

  /** @param {Line} line */
  constructor(line) {
    this.#line = line;
  }

  // A new connection is asked all of it.
  open() {
    for (const [number, watch] of this.#watches) this.#say(number, watch);
  }
  lost() {
    for (const answered of this.#asked.values()) answered({ error: this.#line.notConnected });
    this.#asked.clear();
  }
  /** @param {{ watch: number, past?: number } & Told} message */
  hear(message) {
    const watch = this.#watches.get(message.watch);
    if ((message.past ?? null) === (watch?.always ? null : this.moment)) watch?.take(message);
    if (message.past) this.#asked.get(message.watch)?.(message);
  }
  // The console does not take that question up.
  /** @param {number} number @param {{ error: Failure }} told */
  refused(number, told) {
    this.#asked.get(number)?.(told);
    this.#watches.get(number)?.take(told);
  }

  /** @param {number} number @param {Watched} watch */
  #say(number, watch) {
    if (watch.once) this.#line.say(sym('ask'), number, read(watch.query));
    else if (watch.typed) this.#line.say(sym('watch'), number, watch.query);
    else this.#line.say(sym('follow'), number, read(watch.query));
  }
  /** @param {string} query @param {boolean} typed @param {Listener} listener @param {(failure: Failure) => void} refused */
  #begin(query, typed, listener, refused, always = false) {
    const number = this.#line.number();
    const answers = new LiveAnswers(listener);
    /** @type {Watched} */
    const watch = { query, typed, always, take: (told) => ('error' in told ? refused(told.error) : answers.change(told)) };
    this.#watches.set(number, watch);
    this.#say(number, watch);
    return () => {
      this.#watches.delete(number);
      this.#line.say(sym('unwatch'), number);
    };
  }

  // `always`: of now, whatever moment is shown. Whoever asks the same shares the answers.
  /** @param {string} query @param {Listener} listener */
  follow(query, listener, always = false) {
    const key = `${always} ${query}`;
    /** @type {Shared} */
    const shared = this.#shared.get(key) ?? { listeners: [], told: null };
    shared.listeners.push(listener);
    if (shared.told) listener(...shared.told);
    if (this.#shared.has(key)) return;
    this.#shared.set(key, shared);
    /** @type {Listener} */
    const take = (...told) => {
      shared.told = told;
      for (const each of shared.listeners) each(...told);
    };
    this.#begin(query, false, take, () => {}, always);
  }
  // Answers how to end it.
  /** @param {string} query @param {Listener} listener @param {(failure: Failure) => void} refused */
  watch(query, listener, refused) {
    return this.#begin(query, true, listener, refused);
  }

  // What holds now, asked once: an answer to a request comes before the facts that were told for it.
  /** @param {Datum} query @returns {Promise<Answer[]>} */
  ask(query) {
    const number = this.#line.number();
    return new Promise((resolve) => {
      /** @param {Told} told */
      const take = (told) => {
        this.#watches.delete(number);
        resolve('error' in told ? [] : told.added);
      };
      /** @type {Watched} */
      const watch = { query: write(query), once: true, take, always: true };
      this.#watches.set(number, watch);
      this.#say(number, watch);
    });
  }
  // What held at that time, asked once; throws a failure.
  /** @param {string} query @param {number} microseconds */
  async askThen(query, microseconds) {
    const number = this.#line.number();
    const answer = await this.#then(number, query, microseconds);
    this.#asked.delete(number);
    if ('error' in answer) throw answer.error;
    return answer.added;
  }

  // Shows what held at that time, everywhere; null: what holds now, and goes on. Answers a failure where there is one.
  /** @param {number | null} microseconds @returns {Promise<Failure | null>} */
  async showMoment(microseconds) {
    this.moment = microseconds;
    const shown = [...this.#watches].filter(([, watch]) => !watch.always);
    if (microseconds !== null) return this.#showThen(shown, microseconds);
    for (const [number, watch] of shown) {
      this.#line.say(sym('unwatch'), number);
      this.#say(number, watch);
    }
    return null;
  }
  /** @param {[number, Watched][]} waiting @param {number} microseconds */
  async #showThen(waiting, microseconds) {
    /** @type {Failure | null} */
    let failure = null;
    const next = async () => {
      for (let each = waiting.shift(); each && this.moment === microseconds; each = waiting.shift()) {
        const [number, watch] = each;
        const answer = await this.#then(number, watch.query, microseconds);
        if (!('error' in answer)) continue;
        const undeclared = answer.error.symbol === 'undeclared-relation';
        if (undeclared) watch.take({ resynchronised: true, cut: 0, removed: [], added: [] });
        else failure ??= answer.error;
      }
    };
    await Promise.all(Array.from({ length: atOnce }, next));
    return failure;
  }
  /** @param {number} number @param {string} query @param {number} microseconds @returns {Promise<Told>} */
  #then(number, query, microseconds) {
    return new Promise((resolve) => {
      this.#asked.set(number, resolve);
      if (!this.#line.say(sym('then'), number, read(query), microseconds)) resolve({ error: this.#line.notConnected });
    });
  }
}
