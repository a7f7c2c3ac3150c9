// The page's connection: its WebSocket, which comes back by itself, and what is said and heard on it. Each kind of talk
// is a part of its own: questions.js, requests.js, looks.js (images), held_line.js (a jog), stop_line.js, feeds.js.
//
//   connection.follow('(place ?name ?x ?y ?z ?f)', (answers) => ...)   all that holds, whenever that changes
//   await connection.request('coordinator', '(why)')                    the reply's values; throws a failure
//   connection.look('vision-colour', (picture) => ...)

import { Feeds } from './feeds.js';
import { HeldLine } from './held_line.js';
import { socketAt } from './image_lanes.js';
import { Looks, pictureIn } from './looks.js';
import { Questions } from './questions.js';
import { read, sym, write } from './datum.js';
import { Requests } from './requests.js';
import { Silence } from './silence.js';
import { StopLine } from './stop_line.js';
import { isOutdated } from './version.js';

/** @import { Listener } from './live_answers.js' */
/** @import { Arm, Cell, Datum, Failure, Hello, Message, Method, Picture, Pulse, Reply } from './messages' */
/** @import { Line } from './questions.js' */
/** @typedef {'connecting' | 'live' | 'silent' | 'lost' | 'refused' | 'outdated'} State */

const firstPause = 500; // milliseconds until a lost connection is tried again
const longestPause = 4000;
const heardAfter = 5; // what was taken in is said together
const longestMessage = 16 << 10; // bytes: the console ends a connection on which more is said at once

export class Connection {
  /** @type {WebSocket | null} */
  #socket = null;
  #next = 1;
  #pause = firstPause;
  #heard = 0;
  /** @type {Line} */
  #line = {
    say: (...form) => this.#say(...form),
    number: () => this.#next++,
    notConnected: { symbol: 'unreachable', sentence: 'the console is not connected' },
  };
  #questions = new Questions(this.#line);
  #requests = new Requests(this.#line);
  #looks = new Looks(this.#line);
  #held = new HeldLine(this.#line, this.#requests, this.#looks.lanes);
  #stops = new StopLine(this.#line, this.#requests, this.#looks.lanes);
  #feeds = new Feeds(this.#line);
  #silence = new Silence((state, why) => this.onState(state, why));

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
    this.#heard = 0;
    this.#held.stamp = 0;
    this.#silence.end();
    for (const part of [this.#looks, this.#questions, this.#requests]) part.lost();
    // Whether there is a session at all, only a plain request tells.
    const answer = await fetch('/socket').catch(() => null);
    if (answer?.status === 403) return this.onState('refused', why);
    this.onState('lost', answer?.status === 503 ? (await answer.text()).trim() : why);
    setTimeout(() => this.#connect(), this.#pause);
    this.#pause = Math.min(this.#pause * 2, longestPause);
  }

  /** @param {Datum[]} form */
  #say(...form) {
    if (this.#socket?.readyState !== WebSocket.OPEN) return false;
    const message = write(form);
    if (new TextEncoder().encode(message).length > longestMessage) this.#refuse(Number(form[1]));
    else this.#socket.send(message);
    return true;
  }
  // As the console would refuse it, if it could read so much: what was typed is too long.
  /** @param {number} number */
  #refuse(number) {
    const error = { symbol: 'too-long', sentence: `${longestMessage >> 10} kB are the most that can be said at once` };
    queueMicrotask(() => this.#hear({ reply: number, error }));
  }
  /** @param {Message} message */
  #hear(message) {
    if ('error' in message) message.error.said = message.said;
    if ('hello' in message) this.#greet(message.hello);
    else if ('pulse' in message) this.#beat(message);
    else if ('reply' in message) {
      this.#requests.hear(message.reply, message);
      if ('error' in message) this.#questions.refused(message.reply, message);
    } else {
      if ('watch' in message) this.#questions.hear(message);
      else if (!('arm' in message)) this.#feeds.hear(message);
      else if ((message.past ?? null) === this.moment) this.onArm(message);
      if (!('error' in message)) this.#takenIn();
    }
  }
  /** @param {Hello} hello */
  #greet(hello) {
    this.#pause = firstPause;
    if (isOutdated(String(hello.version))) return this.onState('outdated');
    this.onHello(hello);
    this.onState('live');
    this.#silence.begin();
    this.#looks.open(hello.images);
    for (const part of [this.#stops, this.#questions, this.#feeds]) part.open();
  }
  /** @param {Pulse} pulse */
  #beat(pulse) {
    this.#held.stamp = pulse.pulse;
    this.#silence.heard();
    this.#say(sym('stamp'), pulse.pulse);
    this.onPulse(pulse);
  }
  // The server has so much under way and no more, so that what is urgent never waits behind what is many.
  #takenIn() {
    if (this.#heard++ > 0) return;
    setTimeout(() => {
      this.#say(sym('heard'), this.#heard);
      this.#heard = 0;
    }, heardAfter);
  }

  // The moment that is shown, in microseconds; null: now.
  get moment() {
    return this.#questions.moment;
  }
  showMoment = this.#questions.showMoment.bind(this.#questions);
  /** @param {string} query @param {Listener} listener */
  follow(query, listener) {
    this.#questions.follow(query, listener);
  }
  // What is to be known of now, whatever moment is shown.
  /** @param {string} query @param {Listener} listener */
  followAlways(query, listener) {
    this.#questions.follow(query, listener, true);
  }
  watch = this.#questions.watch.bind(this.#questions);
  ask = this.#questions.ask.bind(this.#questions);
  askThen = this.#questions.askThen.bind(this.#questions);

  /** @param {string} agent @param {string | Datum[]} operation @returns {Promise<string[]>} */
  request(agent, operation) {
    return this.#requests.call('request', sym(agent), typeof operation === 'string' ? read(operation) : operation);
  }
  /** @param {string} typed @param {(reply: Reply) => void} ended */
  goal(typed, ended) {
    return this.#requests.callWith(ended, 'goal', typed);
  }
  // Answers when it is told, and tells meanwhile of each line that did not acknowledge it.
  /** @param {string} reason @param {(failure: Failure) => void} unheard */
  stop(reason, unheard) {
    return this.#stops.stop(reason, unheard);
  }
  clearStops() {
    return this.#requests.call('clear-stops');
  }
  /** @param {'command' | 'take-over' | 'let-go' | 'ask-for' | 'ask-no-more'} verb @param {string} robot */
  hold(verb, robot) {
    return this.#requests.call(verb, sym(robot));
  }
  // How the cells do that this board names; `more` says that there are others beyond a bound.
  /** @returns {Promise<{ cells: Cell[], more: boolean }>} */
  async cells() {
    const [seen] = await this.#requests.call('cells');
    return JSON.parse(seen);
  }
  /** @param {number} seconds @returns {Promise<Method>} */
  async method(seconds) {
    const [report] = await this.#requests.call('method', seconds);
    return JSON.parse(report);
  }

  jog = this.#held.jog.bind(this.#held);
  holdOn = this.#held.holdOn.bind(this.#held);
  release = this.#held.release.bind(this.#held);
  layTruth = this.#feeds.layTruth.bind(this.#feeds);
  sampleActivity = this.#feeds.sampleActivity.bind(this.#feeds);
  earlierWork = this.#feeds.earlierWork.bind(this.#feeds);
  look = this.#looks.add.bind(this.#looks);

  // What was seen then, if it was kept.
  /** @param {string} stream @param {number} microseconds @returns {Promise<Picture>} */
  async picture(stream, microseconds) {
    const [kept] = await this.#requests.call('picture', sym(stream), microseconds);
    return kept;
  }
  // One that was asked for.
  /** @param {ArrayBuffer} message */
  async #showKept(message) {
    const [request, picture] = await pictureIn(message);
    this.#requests.hear(request, picture ? { values: [picture] } : { error: { sentence: 'what was kept is no picture' } });
  }
}
