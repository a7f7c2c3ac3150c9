// TRAINING: a click in the camera's image learns what is there, in the frame that was clicked. A window then shows what
// was learned; it is named and accepted there, or rejected. With a name given first it becomes another sample of that
// object.

import { element, failureText } from './dom.js';
import { endEffector } from './learned_objects.js';
import { LearnedWindow, nameRules } from './learned_window.js';
import { sym } from './datum.js';
import { whyFailed } from './eyes_requests.js';

/** @import { EyesRequests } from './eyes_requests.js' */
/** @import { LearnedObjects } from './learned_objects.js' */
/** @import { PointInImage } from './messages' */

// (LEARN "name" OK) is no failure of the request where it says FAIL.
/** @param {string[]} values */
const isLearned = (values) => /^\(LEARN ".*" OK\)$/.test(values[0] ?? '');

export class Teaching {
  #eyes;
  #objects;
  #provisional;
  #busy = false; // learning, or accepting or rejecting what was learned: the next click is not taken
  /** @type {string | null} */
  #learned = null; // under which name, until it is accepted or rejected
  #window;
  training = element('button', { type: 'button', id: 'training', 'aria-pressed': 'false' }, 'Training: off');
  #hint = element('p', { class: 'quiet', id: 'teach-hint', role: 'status' });
  #name = element('input', { id: 'learn-name', list: 'learned-names', placeholder: 'a name, or none yet', ...nameRules });
  #known = element('datalist', { id: 'learned-names' });
  panel;

  // `provisional`: what this page calls an object that nobody has named yet.
  /** @param {EyesRequests} eyes @param {LearnedObjects} objects @param {() => string} provisional */
  constructor(eyes, objects, provisional) {
    this.#eyes = eyes;
    this.#objects = objects;
    this.#provisional = provisional;
    this.#window = new LearnedWindow(objects, { accept: (name) => this.#accept(name), reject: () => this.#reject() });
    this.training.addEventListener('click', () => this.#switch(!this.#on));
    this.panel = element(
      'div',
      { class: 'teaching' },
      element('div', { class: 'row' }, this.training, element('label', { for: 'learn-name' }, 'Name'), this.#name),
      this.#known,
      this.#hint,
      this.#window.panel,
    );
    objects.onChange(() => {
      this.#showNames();
      if (!this.#busy) this.#window.showSample();
    });
    this.#showNames();
  }

  get #on() {
    return this.training.getAttribute('aria-pressed') === 'true';
  }
  /** @param {boolean} on */
  #switch(on) {
    this.training.setAttribute('aria-pressed', String(on));
    this.training.textContent = `Training: ${on ? 'on' : 'off'}`;
    document.body.classList.toggle('training', on);
    this.#showNames();
  }
  /** @param {string} sentence */
  #say(sentence) {
    this.#hint.textContent = sentence;
  }

  #showNames() {
    const names = this.#objects.names().filter((name) => name !== this.#provisional());
    this.#known.replaceChildren(...names.map((name) => element('option', { value: name })));
    if (this.#busy) return;
    const begin = names.includes(endEffector) ? '' : ' Begin with the end-effector: the triangle on the gripper.';
    this.#say(this.#on ? `Click on a mark in the camera’s image.${begin}` : 'Switch training on, and click on a mark.');
    if (this.#on && begin && this.#name.value === '') this.#name.value = endEffector;
  }

  // The next click is one more sample of that object.
  /** @param {string} name */
  more(name) {
    this.#switch(true);
    this.#name.value = name;
  }

  // Answers whether the click was taken.
  /** @param {PointInImage} point */
  take(point) {
    if (!this.#on) return false;
    if (this.#busy || !this.#name.reportValidity()) return true;
    this.#learn(point, this.#name.value || this.#provisional());
    return true;
  }

  /** @param {PointInImage} point @param {string} name */
  async #learn(point, name) {
    this.#busy = true;
    this.#window.hide();
    this.#say(`Learning what is at ${point.x}, ${point.y} of frame ${point.frame}: red while it is filled, then its border.`);
    const before = this.#objects.newest(name)?.num ?? 0;
    try {
      const values = await this.#eyes.values(sym('learn'), point.x, point.y, point.frame, name);
      if (!isLearned(values)) throw { said: `${values[0] ?? 'FAIL'}: ${whyFailed(values)}` };
      this.#learned = name;
      this.#window.open({ name, isNew: name === this.#provisional(), before });
      this.#say('Learned. Accept it under a name, or reject it.');
    } catch (failure) {
      this.#say(`${failureText(failure)}. For one more sample of an object write its name first; then click again.`);
    }
    this.#busy = false;
  }

  // One at a time: a click meanwhile would be taken under the name that is just being given.
  /** @param {string} saying @param {(learned: string) => Promise<unknown>} work @param {string} done */
  async #end(saying, work, done) {
    const learned = this.#learned;
    if (this.#busy || learned === null) return;
    this.#busy = true;
    this.#say(saying);
    let sentence = done;
    try {
      await work(learned);
      this.#learned = null;
      this.#window.hide();
      this.#name.value = '';
    } catch (failure) {
      sentence = failureText(failure);
    }
    this.#busy = false;
    this.#showNames();
    this.#say(sentence);
  }
  /** @param {string} name */
  #accept(name) {
    /** @param {string} learned */
    const work = async (learned) => {
      if (name !== learned) await this.#eyes.values(sym('rename'), learned, name);
      this.#learned = name;
      this.#window.rename(name);
      await this.#eyes.values(sym('accept'), name);
    };
    return this.#end(`Accepting ${name} …`, work, `${name} is accepted. Click on the next mark.`);
  }
  #reject() {
    const work = (/** @type {string} */ learned) => this.#eyes.values(sym('reject'), learned);
    return this.#end('Rejecting …', work, 'Rejected: nothing was learned.');
  }
}
