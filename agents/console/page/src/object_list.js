// The learned objects as a list: the templates of each, whether it is tracked, its look-alikes, and the buttons that act
// on it alone.
//
//   const list = new ObjectList(objects, requests, (name) => ...);     who adds a sample of an object
//   list.draw(); list.showTracked(facts); list.gate(reasons, why);

import { arrange, clipped, element } from './dom.js';
import { isNamed } from './learned_objects.js';
import { sym, text } from './datum.js';
import { templatePicture } from './template_picture.js';

/** @import { EyesRequests } from './eyes_requests.js' */
/** @import { LearnedObjects, Sample } from './learned_objects.js' */
/** @import { Reasons } from './reasons.js' */
/** @import { WhyOff } from './why_eyes_off.js' */
/** @import { Form } from './messages' */

const shown = 64;

/** `of`: what the row shows, as text.
 * @typedef {{ of: string, item: HTMLElement, state: HTMLElement, buttons: Record<'find' | 'track' | 'more' | 'forget', HTMLButtonElement> }} Row */

// Of `(tracked EYES NAME STATE FRAME CONFIDENCE)`.
/** @param {Form} tracked */
const stateOf = ([, , , state, , confidence]) => (text(state) === 'lost' ? 'lost' : `${text(state)}, ${(confidence * 100).toFixed(0)} %`);

/** @param {string} name @param {Sample[]} samples */
function templates(name, samples) {
  const pictures = samples.map((one) => templatePicture(one.picture, one.tone, `Sample ${one.num} of ${clipped(name, 64)}`));
  return element('span', { class: 'templates' }, ...pictures);
}

/** @param {string} name @param {Sample[]} samples @param {string[]} alike @param {HTMLElement} state */
function description(name, samples, alike, state) {
  const by = [...new Set(samples.map((one) => one.eyes))].join(', ');
  const count = ` ${samples.length} sample${samples.length > 1 ? 's' : ''} by ${clipped(by, 64)}; `;
  return element(
    'span',
    {},
    element('strong', {}, isNamed(name) ? clipped(name, 64) : 'not named yet'),
    element('span', { class: 'quiet' }, count, state),
    ...alike.map((sentence) => element('small', { class: 'warn' }, clipped(sentence, 160))),
  );
}

export class ObjectList {
  #objects;
  #requests;
  #addSample;
  /** @type {Map<string, Row>} */
  #rows = new Map();
  /** @type {Map<string, Form>} */
  #tracked = new Map();
  panel = element('ul', { class: 'objects', 'aria-label': 'Learned objects' });

  /** @param {LearnedObjects} objects @param {EyesRequests} requests @param {(name: string) => void} addSample */
  constructor(objects, requests, addSample) {
    this.#objects = objects;
    this.#requests = requests;
    this.#addSample = addSample;
  }

  draw() {
    const names = this.#objects.names().slice(0, shown);
    for (const name of this.#rows.keys()) if (!names.includes(name)) this.#rows.delete(name);
    arrange(this.panel, names.map((name) => this.#row(name).item));
    this.#showStates();
  }
  /** @param {Form[]} facts */
  showTracked(facts) {
    this.#tracked = new Map(facts.map((one) => [text(one[2]), one]));
    this.#showStates();
  }
  /** @param {Reasons} reasons @param {WhyOff} why */
  gate(reasons, why) {
    const buttons = [...this.#rows.values()].map((row) => row.buttons);
    reasons.set('Add sample', buttons.map(({ more }) => more), why.train);
    reasons.set('Find', buttons.map(({ find }) => find), why.find);
    reasons.set('Track', buttons.map(({ track }) => track), why.track);
    reasons.set('Forget', buttons.map(({ forget }) => forget), why.forget);
  }

  #showStates() {
    for (const [name, { state }] of this.#rows) {
      const seen = this.#tracked.get(name);
      state.textContent = seen ? stateOf(seen) : 'not tracked';
    }
  }
  // Made anew only where what it shows has changed.
  /** @param {string} name @returns {Row} */
  #row(name) {
    const samples = this.#objects.samples(name);
    const alike = this.#objects.alike(name);
    const of = JSON.stringify([samples, alike]);
    const there = this.#rows.get(name);
    if (there?.of === of) return there;
    const state = element('span', {});
    const buttons = this.#buttons(name);
    const { find, track, more, forget } = buttons;
    const item = element(
      'li',
      {},
      templates(name, samples),
      description(name, samples, alike, state),
      element('span', { class: 'buttons' }, find, track, more, forget),
    );
    const row = { of, item, state, buttons };
    this.#rows.set(name, row);
    return row;
  }
  /** @param {string} name */
  #buttons(name) {
    return {
      find: this.#requests.button('Find', sym('find'), name),
      track: this.#requests.button('Track', sym('track'), name),
      more: element('button', { type: 'button', onclick: () => this.#addSample(name) }, 'Add sample'),
      forget: this.#requests.button('Forget', sym('forget'), name),
    };
  }
}
