// The page's connection: questions that live on, requests that are answered; images come on lanes beside it. It comes
// back by itself.
//
//   connection.follow('(place ?name ?x ?y ?z ?f)', (answers) => ...)   all that holds, whenever that changes
//   await connection.request('coordinator', '(why)')                    the reply's values; throws a failure
//   connection.look('vision-colour', (picture) => ...)

import { ImageLanes, socketAt } from './image_lanes.js';
import { LiveAnswers } from './live_answers.js';
import { read, text, write, sym } from './datum.js';

/** @import { Listener } from './live_answers.js' */
/** @import { Activity, Answer, Arm, Cell, Change, Datum, Failure, Form, Hello, Lasting, Message, Method, Picture, Pulse, Reply } from './messages' */
/** A question that lives on, or that is asked `once`. `always` is of now, whatever moment is shown.
 * @typedef {{ query: string, typed?: boolean, once?: boolean, always: boolean, take: (told: Told) => void }} Watched
 * @typedef {Change | { error: Failure }} Told
 * @typedef {{ reject: (failure: Failure) => void, take: (reply: Reply) => void }} Request
 * @typedef {{ listeners: Listener[], told: Parameters<Listener> | null }} Shared
 * @typedef {'connecting' | 'live' | 'silent' | 'lost' | 'refused'} State
 * What is told of the truth and of what goes on, or null and why that is not known; and what went on before.
 * @typedef {(truth: Form | null, why?: string) => void} ShowTruth
 * @typedef {(sample: Activity | null, why?: string) => void} ShowActivity
 * @typedef {(kind: 'servo' | 'sightings', changes: Lasting[]) => void} ShowWork
 */

const longestLate = 5e6; // microseconds
// Stamps come once a second at least.
const longestSilence = 2500; // milliseconds
const notConnected = { symbol: 'unreachable', sentence: 'the console is not connected' };

// Of `(image STREAM NUMBER CAPTURED-US WIDTH HEIGHT)` or `(picture REQUEST ...)`, a newline and a JPEG: what it is of, and
// the picture, if it is one.
/** @param {ArrayBuffer} message @returns {Promise<[of: any, picture: Picture | null]>} */
async function pictureIn(message) {
  const bytes = new Uint8Array(message);
  const end = bytes.indexOf(10);
  const [, of, number, captured, width, height] = read(new TextDecoder().decode(bytes.subarray(0, end)));
  const blob = new Blob([bytes.subarray(end + 1)], { type: 'image/jpeg' });
  const bitmap = await createImageBitmap(blob).catch(() => null);
  return [of, bitmap && { bitmap, number, captured, width, height }];
}

export class Connection {
  /** @type {WebSocket | null} */
  #socket = null;
  #next = 1;
  /** @type {Map<number, Watched>} */
  #watches = new Map();
  /** @type {Map<number, Request>} */
  #requests = new Map();
  /** @type {Map<string, (picture: Picture) => void>} */
  #looks = new Map();
  #lanes = new ImageLanes((message) => this.#drawImage(message));
  /** @type {Map<string, number>} */
  #newest = new Map(); // of each stream, when what is shown was captured
  /** @type {Map<string, Shared>} */
  #shared = new Map(); // what is followed, by its query
  #pause = 500;
  #heard = 0;
  #stamp = 0;
  #stamped = 0; // when that came, by the page's own clock
  /** @type {number | undefined} */
  #listening; // the timer that finds the line silent
  #silent = false;
  #jog = 0; // the request that the page holds on to
  /** @type {ShowTruth | null} */
  #laid = null; // who is shown the world's truth
  /** @type {ShowActivity | null} */
  #sampled = null; // and what goes on on the board
  /** @type {ShowWork | null} */
  #earlier = null; // and what went on before this page was opened
  /** @type {number | null} */
  #moment = null; // what is shown is of then, in microseconds; null: of now
  /** @type {Map<number, (told: Told) => void>} */
  #asked = new Map(); // questions of the past, by their watches

  /** @type {(state: State, why?: string) => void} */
  onState = () => {};
  /** @type {(hello: Hello) => void} */
  onHello = () => {};
  /** @type {(arm: Arm) => void} */
  onArm = () => {};
  /** @type {(pulse: Pulse) => void} */
  onPulse = () => {}; // { deadline, rtt } in ms; rtt is negative before it is known

  // The token behind the # is of use once, and is not left where others could read it.
  async open() {
    const token = location.hash.slice(1);
    if (token) history.replaceState(null, '', location.pathname);
    await this.logIn(token);
  }
  /** @param {string} token */
  async logIn(token) {
    if (token) await fetch('/session', { method: 'POST', headers: { Authorization: `Bearer ${token}` } }).catch(() => null);
    this.#connect();
  }
  async logOut() {
    await fetch('/socket', { method: 'DELETE' }).catch(() => null);
    location.reload();
  }

  #connect() {
    this.onState('connecting');
    const socket = socketAt('/socket');
    socket.onmessage = (event) =>
      typeof event.data === 'string' ? this.#hear(JSON.parse(event.data)) : this.#showKept(event.data);
    socket.onclose = ({ reason }) => this.#lost(reason);
    this.#socket = socket;
  }

  /** @param {string} why what the console said of it, if it said anything */
  async #lost(why) {
    this.#socket = null;
    this.#lanes.close();
    this.#heard = 0;
    this.#stamp = 0;
    clearInterval(this.#listening);
    for (const answered of this.#asked.values()) answered({ error: notConnected });
    this.#asked.clear();
    for (const request of this.#requests.values()) {
      request.reject({ symbol: 'unreachable', sentence: 'the console has gone; whether it was done is not known' });
    }
    this.#requests.clear();
    // Whether there is a session at all, only a plain request tells.
    const answer = await fetch('/socket').catch(() => null);
    if (answer?.status === 403) return this.onState('refused');
    this.onState('lost', why);
    setTimeout(() => this.#connect(), this.#pause);
    this.#pause = Math.min(this.#pause * 2, 4000);
  }

  /** @param {Datum[]} form */
  #say(...form) {
    if (this.#socket?.readyState !== WebSocket.OPEN) return false;
    this.#socket.send(write(form));
    return true;
  }

  /** @param {Message} message */
  #hear(message) {
    if ('error' in message) message.error.said = message.said;
    if ('hello' in message) {
      this.#pause = 500;
      this.onHello(message.hello);
      this.onState('live');
      this.#listen();
      this.#lanes.open(message.hello.images);
      for (const [number, watch] of this.#watches) this.#ask(number, watch);
      for (const name of this.#looks.keys()) this.#say(sym('look'), sym(name));
      if (this.#laid) this.#say(sym('truth'));
      if (this.#sampled) this.#say(sym('activity'));
      if (this.#earlier) this.#say(sym('work'), this.#next++);
    } else if ('arm' in message) {
      if ((message.past ?? null) === this.#moment) this.onArm(message);
      this.#takenIn();
    } else if ('watch' in message) {
      const watch = this.#watches.get(message.watch);
      if ((message.past ?? null) === (watch?.always ? null : this.#moment)) watch?.take(message);
      if (!('error' in message)) this.#takenIn();
      if (message.past) this.#asked.get(message.watch)?.(message);
    } else if ('truth' in message) {
      this.#laid?.(message.truth === null ? null : read(message.truth), message.said);
      this.#takenIn();
    } else if ('activity' in message) {
      this.#sampled?.(message.activity, message.said);
      this.#takenIn();
    } else if ('work' in message) {
      this.#earlier?.(message.work, message.changes);
      this.#takenIn();
    } else if ('pulse' in message) {
      this.#stamp = message.pulse;
      this.#stamped = performance.now();
      if (this.#silent) this.#noteSilence();
      this.#say(sym('stamp'), message.pulse);
      this.onPulse(message);
    } else {
      this.#requests.get(message.reply)?.take(message);
      if (!('error' in message)) return;
      // A question that the console refuses to take up.
      this.#asked.get(message.reply)?.(message);
      this.#watches.get(message.reply)?.take(message);
    }
  }

  // A line that is lost on its way ends no connection: what is missing says so.
  #listen() {
    clearInterval(this.#listening);
    this.#silent = false;
    this.#stamped = performance.now();
    this.#listening = setInterval(() => this.#noteSilence(), 250);
  }
  #noteSilence() {
    const silence = performance.now() - this.#stamped;
    const before = this.#silent;
    this.#silent = silence > longestSilence;
    if (this.#silent) this.onState('silent', `for ${Math.floor(silence / 1000)} s`);
    else if (before) this.onState('live');
  }

  // The server has so much under way and no more, so that what is urgent never waits behind what is many.
  #takenIn() {
    if (this.#heard++ > 0) return;
    setTimeout(() => {
      this.#say(sym('heard'), this.#heard);
      this.#heard = 0;
    }, 5);
  }

  /** @param {number} number @param {Watched} watch */
  #ask(number, watch) {
    if (watch.once) this.#say(sym('ask'), number, read(watch.query));
    else if (watch.typed) this.#say(sym('watch'), number, watch.query);
    else this.#say(sym('follow'), number, read(watch.query));
  }

  /** @param {string} query @param {boolean} typed @param {Listener} listener @param {(failure: Failure) => void} refused */
  #begin(query, typed, listener, refused, always = false) {
    const number = this.#next++;
    const answers = new LiveAnswers(listener);
    /** @type {Watched} */
    const watch = { query, typed, always, take: (told) => ('error' in told ? refused(told.error) : answers.change(told)) };
    this.#watches.set(number, watch);
    this.#ask(number, watch);
    return () => {
      this.#watches.delete(number);
      this.#say(sym('unwatch'), number);
    };
  }

  // What is to be known of now, whatever moment is shown, is always followed. Whoever asks the same shares the answers.
  /** @param {string} query @param {Listener} listener */
  follow(query, listener) {
    this.#share(query, listener, false);
  }
  /** @param {string} query @param {Listener} listener */
  followAlways(query, listener) {
    this.#share(query, listener, true);
  }
  /** @param {string} query @param {Listener} listener @param {boolean} always */
  #share(query, listener, always) {
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
    const number = this.#next++;
    return new Promise((resolve) => {
      /** @param {Told} told */
      const take = (told) => {
        this.#watches.delete(number);
        resolve('error' in told ? [] : told.added);
      };
      /** @type {Watched} */
      const watch = { query: write(query), once: true, take, always: true };
      this.#watches.set(number, watch);
      this.#ask(number, watch);
    });
  }

  // What held at that time, asked once; throws a failure.
  /** @param {string} query @param {number} microseconds */
  async askThen(query, microseconds) {
    const number = this.#next++;
    const answer = await this.#then(number, query, microseconds);
    this.#asked.delete(number);
    if ('error' in answer) throw answer.error;
    return answer.added;
  }

  // The moment that is shown, in microseconds; null: now.
  get moment() {
    return this.#moment;
  }

  // Shows what held at that time, everywhere; null: what holds now, and goes on. Answers a failure where there is one.
  /** @param {number | null} microseconds @returns {Promise<Failure | null>} */
  async showMoment(microseconds) {
    this.#moment = microseconds;
    if (microseconds === null) {
      for (const [number, watch] of this.#watches) {
        if (watch.always) continue;
        this.#say(sym('unwatch'), number);
        this.#ask(number, watch);
      }
      return null;
    }
    const waiting = [...this.#watches].filter(([, watch]) => !watch.always);
    /** @type {Failure | null} */
    let failure = null;
    const next = async () => {
      for (let each = waiting.shift(); each && this.#moment === microseconds; each = waiting.shift()) {
        const [number, watch] = each;
        const answer = await this.#then(number, watch.query, microseconds);
        if (!('error' in answer)) continue;
        const undeclared = answer.error.symbol === 'undeclared-relation';
        if (undeclared) watch.take({ resynchronised: true, cut: 0, removed: [], added: [] });
        else failure ??= answer.error;
      }
    };
    await Promise.all([next(), next(), next(), next()]);
    return failure;
  }
  /** @param {number} number @param {string} query @param {number} microseconds @returns {Promise<Told>} */
  #then(number, query, microseconds) {
    return new Promise((resolve) => {
      this.#asked.set(number, resolve);
      if (!this.#say(sym('then'), number, read(query), microseconds)) resolve({ error: notConnected });
    });
  }

  // `more` hears what comes after the first answer.
  /** @param {((reply: Reply) => void) | null} more @param {string} verb @param {Datum[]} rest */
  #call(more, verb, ...rest) {
    return this.#callAs(this.#next++, more, verb, ...rest);
  }
  /** @param {number} number @param {((reply: Reply) => void) | null} more @param {string} verb @param {Datum[]} rest @returns {Promise<any[]>} */
  #callAs(number, more, verb, ...rest) {
    return new Promise((resolve, reject) => {
      /** @param {Reply} message */
      const take = (message) => {
        if (more && !('error' in message))
          this.#requests.set(number, { reject: () => {}, take: (later) => this.#end(number, more, later) });
        else this.#requests.delete(number);
        if ('error' in message) reject(message.error);
        else resolve(message.values);
      };
      this.#requests.set(number, { reject, take });
      if (this.#say(sym(verb), number, ...rest)) return;
      this.#requests.delete(number);
      reject(notConnected);
    });
  }
  /** @param {number} number @param {(reply: Reply) => void} more @param {Reply} message */
  #end(number, more, message) {
    this.#requests.delete(number);
    more(message);
  }

  /** @param {string} agent @param {string | Datum[]} operation @returns {Promise<string[]>} */
  request(agent, operation) {
    return this.#call(null, 'request', sym(agent), typeof operation === 'string' ? read(operation) : operation);
  }
  /** @param {string} typed @param {(reply: Reply) => void} ended */
  goal(typed, ended) {
    return this.#call(ended, 'goal', typed);
  }
  /** @param {string} reason */
  stop(reason) {
    return this.#call(null, 'stop', reason);
  }
  clearStops() {
    return this.#call(null, 'clear-stops');
  }
  /** @param {'command' | 'take-over' | 'let-go' | 'ask-for' | 'ask-no-more'} verb @param {string} robot */
  hold(verb, robot) {
    return this.#call(null, verb, sym(robot));
  }

  // Five times a second, until it ends: what the simulated world is like, or null and why that is not known.
  /** @param {ShowTruth | null} show */
  layTruth(show) {
    this.#laid = show;
    this.#say(sym(show ? 'truth' : 'truth-no-more'));
  }
  // Once a second, until it ends: what goes on on the board.
  /** @param {ShowActivity | null} show */
  sampleActivity(show) {
    this.#sampled = show;
    this.#say(sym(show ? 'activity' : 'activity-no-more'));
  }
  // Some at a time, and anew with each connection: `show('servo', changes)`, `show('sightings', changes)`.
  /** @param {ShowWork} show */
  earlierWork(show) {
    this.#earlier = show;
    this.#say(sym('work'), this.#next++);
  }
  // How the cells do that this board names; `more` says that there are others beyond a bound.
  /** @returns {Promise<{ cells: Cell[], more: boolean }>} */
  async cells() {
    const [seen] = await this.#call(null, 'cells');
    return JSON.parse(seen);
  }
  /** @param {number} seconds @returns {Promise<Method>} */
  async method(seconds) {
    const [report] = await this.#call(null, 'method', seconds);
    return JSON.parse(report);
  }

  // The arm moves while holdOn() comes in time, and until release(); answers when it has ended.
  /** @param {string} robot @param {string} direction */
  jog(robot, direction) {
    this.#jog = this.#next++;
    const words = [sym(robot), sym(direction), this.#stamp];
    this.#repeat('jog', ...words);
    return this.#callAs(this.#jog, null, 'jog', ...words);
  }
  holdOn() {
    this.#say(sym('hold-on'), this.#jog, this.#stamp);
    this.#repeat('hold-on', this.#stamp);
  }
  release() {
    this.#say(sym('release'), this.#jog);
    this.#repeat('release');
  }
  // What moves the arm goes two ways, so that one lost packet does not hold it back: the console takes what comes first.
  /** @param {string} verb @param {Datum[]} rest */
  #repeat(verb, ...rest) {
    this.#lanes.say(write([sym(verb), this.#jog, ...rest]));
  }

  /** @param {string} stream @param {(picture: Picture) => void} show */
  look(stream, show) {
    this.#looks.set(stream, show);
    this.#say(sym('look'), sym(stream));
    return () => {
      this.#looks.delete(stream);
      this.#say(sym('look-away'), sym(stream));
    };
  }

  // What was seen then, if it was kept.
  /** @param {string} stream @param {number} microseconds @returns {Promise<Picture>} */
  async picture(stream, microseconds) {
    const [kept] = await this.#call(null, 'picture', sym(stream), microseconds);
    return kept;
  }

  // One that was asked for.
  /** @param {ArrayBuffer} message */
  async #showKept(message) {
    const [request, picture] = await pictureIn(message);
    const kept = picture ? { values: [picture] } : { error: { sentence: 'what was kept is no picture' } };
    this.#requests.get(request)?.take(kept);
  }

  // Where a newer one is shown already, it came too late. A clock that was set back makes all of them older.
  /** @param {ArrayBuffer} message */
  async #drawImage(message) {
    const [name, picture] = await pictureIn(message);
    // A hidden page draws nothing, and so is sent nothing.
    await new Promise(requestAnimationFrame);
    if (!picture) return;
    const { captured } = picture;
    const newest = this.#newest.get(text(name)) ?? 0;
    if (captured >= newest || newest - captured > longestLate) {
      this.#newest.set(text(name), captured);
      this.#looks.get(text(name))?.(picture);
    }
    picture.bitmap.close();
  }
}
