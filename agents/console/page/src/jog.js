// The held jog: the arm moves while a button is held down, by pointer or key. The page renews its hold every 50 ms with
// the newest stamp of the server; the robot's agent stops the arm when that stays away, whatever has become of the page.
// Letting go, losing the focus and being hidden end it at once.

import { element } from './dom.js';

/** @import { CommandLog } from './command_log.js' */
/** @import { Connection } from './connection.js' */
/** @import { Hands } from './hands.js' */

const renewal = 50;

// A column is a way there and back.
const ways = [
  ['left', '◀', 'Left'],
  ['up', '▲', 'Up'],
  ['out', '⇧', 'Out'],
  ['turn-left', '⟲', 'Turn left'],
  ['tool-up', '⤒', 'Tool up'],
  ['wrist-left', '↺', 'Wrist left'],
  ['right', '▶', 'Right'],
  ['down', '▼', 'Down'],
  ['in', '⇩', 'In'],
  ['turn-right', '⟳', 'Turn right'],
  ['tool-down', '⤓', 'Tool down'],
  ['wrist-right', '↻', 'Wrist right'],
];

class Jog {
  #connection;
  #hands;
  #log;
  /** @type {number | undefined} */
  #timer;
  /** @type {{ button: HTMLButtonElement } | null} */
  #press = null; // while one is held down
  /** @type {Promise<void> | null} */
  #running = null; // until the last one has ended

  /** @param {Connection} connection @param {Hands} hands @param {CommandLog} log */
  constructor(connection, hands, log) {
    this.#connection = connection;
    this.#hands = hands;
    this.#log = log;
    hands.onChange(() => hands.why && this.end());
    window.addEventListener('blur', () => this.end());
    window.addEventListener('pagehide', () => this.end());
    document.addEventListener('visibilitychange', () => {
      if (document.hidden) this.end();
    });
  }

  // One that was just let go ends first.
  /** @param {string} direction @param {HTMLButtonElement} button */
  begin(direction, button) {
    if (this.#press || this.#hands.why) return;
    const press = { button };
    this.#press = press;
    button.classList.add('held');
    const start = () => this.#press === press && this.#start(direction, press);
    if (this.#running) this.#running.then(start);
    else start();
  }

  /** @param {string} direction @param {{ button: HTMLButtonElement }} press */
  #start(direction, press) {
    const ended = this.#connection.jog(this.#hands.robot, direction);
    this.#log.follow(`(jog ${direction})`, ended);
    this.#timer = setInterval(() => this.#connection.holdOn(), renewal);
    const over = () => {
      this.#running = null;
      if (this.#press === press) this.end();
    };
    this.#running = ended.then(over, over);
  }

  end() {
    if (!this.#press) return;
    clearInterval(this.#timer);
    this.#connection.release();
    this.#press.button.classList.remove('held');
    this.#press = null;
  }
}

/** @param {Jog} jog @param {string[]} way */
function heldButton(jog, [direction, sign, label]) {
  const button = element(
    'button',
    { type: 'button', class: 'jog', 'data-jog': direction, 'aria-label': `Jog: ${label}`, title: label },
    element('span', { 'aria-hidden': 'true' }, sign),
    element('small', { 'aria-hidden': 'true' }, label),
  );
  button.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    button.setPointerCapture(event.pointerId);
    jog.begin(direction, button);
  });
  for (const end of ['pointerup', 'pointercancel', 'lostpointercapture', 'blur']) {
    button.addEventListener(end, () => jog.end());
  }
  button.addEventListener('contextmenu', (event) => event.preventDefault());
  button.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') jog.end();
    if (event.key !== ' ' && event.key !== 'Enter') return;
    event.preventDefault();
    if (!event.repeat) jog.begin(direction, button);
  });
  button.addEventListener('keyup', (event) => {
    if (event.key === ' ' || event.key === 'Enter') jog.end();
  });
  return button;
}

// The pad and its buttons, for who decides when they may be pressed.
/** @param {Connection} connection @param {Hands} hands @param {CommandLog} log */
export function makeJog(connection, hands, log) {
  const jog = new Jog(connection, hands, log);
  const buttons = ways.map((way) => heldButton(jog, way));
  const note = element('p', { class: 'quiet', id: 'jog-note' }, '');
  connection.onPulse = ({ deadline, rtt }) => {
    const line = rtt < 0 ? 'not measured yet' : `${rtt.toFixed(0)} ms there and back`;
    note.textContent = `Hold to move. Line: ${line}; silence of ${deadline.toFixed(0)} ms stops the arm, within 10 mm.`;
  };
  const pad = element('div', { class: 'jogs', role: 'group', 'aria-label': 'Jog: hold to move' }, ...buttons);
  return { parts: [pad, note], buttons };
}
