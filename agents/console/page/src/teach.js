// TRAINING: a click in the camera's image learns what is there, in the frame that was clicked. Then a window shows what
// was learned (Table C.1), and it is named and accepted, or rejected. With a name given first it becomes another sample
// of that object.

import { clipped, element, failureText } from './dom.js';
import { endEffector } from './learned_objects.js';
import { sym } from './datum.js';
import { templatePicture } from './template_picture.js';

/** @import { LearnedObjects } from './learned_objects.js' */
/** @import { Datum, PointInImage } from './messages' */

// What marks are mostly called: a press names one without a keyboard.
const usual = [endEffector, 'circle', 'triangle', 'square', 'cross'];

// (LEARN "name" OK) is no failure of the request where it says FAIL.
/** @param {string[]} values */
const isLearned = (values) => /^\(LEARN ".*" OK\)$/.test(values[0] ?? '');

export class Teaching {
  #ask; // (operation...) answers the values
  #objects;
  #provisional;
  #why; // answers why that reply of the eyes says FAIL
  #busy = false; // learning, or accepting or rejecting what was learned: the next click is not taken
  /** @type {{ name: string, before: number } | null} */
  #learned = null; // what is to be named: { name, before }, the number of its newest sample before
  panel = element('div', { class: 'teaching' });
  training = element('button', { type: 'button', id: 'training', 'aria-pressed': 'false' }, 'Training: off');
  #hint = element('p', { class: 'quiet', id: 'teach-hint', role: 'status' });
  #name = element('input', {
    id: 'learn-name',
    list: 'learned-names',
    maxlength: 64,
    spellcheck: 'false',
    placeholder: 'a name, or none yet',
    pattern: '[A-Za-z][A-Za-z0-9\\-]*',
    title: 'a letter, then letters, digits and hyphens',
  });
  #known = element('datalist', { id: 'learned-names' });
  #sample = element('div', { class: 'learned-sample' });
  #window = element('div', { class: 'learned-window', id: 'learned-window', role: 'group', hidden: true });

  /** @param {{ ask: (...operation: Datum[]) => Promise<string[]>, objects: LearnedObjects, provisional: () => string, why: (reply: string) => Promise<string> }} eyes */
  constructor({ ask, objects, provisional, why }) {
    this.#ask = ask;
    this.#objects = objects;
    this.#provisional = provisional;
    this.#why = why;
    this.training.addEventListener('click', () => this.#switch(!this.#on));
    this.panel.append(
      element('div', { class: 'row' }, this.training, element('label', { for: 'learn-name' }, 'Name'), this.#name),
      this.#known,
      this.#hint,
      this.#window,
    );
    objects.onChange(() => {
      this.#showNames();
      if (!this.#busy) this.#showSample();
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

  /** @param {string} name */
  #number(name) {
    return this.#objects.newest(name)?.num ?? 0;
  }

  /** @param {PointInImage} point @param {string} name */
  async #learn(point, name) {
    this.#busy = true;
    this.#window.hidden = true;
    this.#say(`Learning what is at ${point.x}, ${point.y} of frame ${point.frame}: red while it is filled, then its border.`);
    const before = this.#number(name);
    try {
      const values = await this.#ask(sym('learn'), point.x, point.y, point.frame, name);
      if (!isLearned(values)) throw { said: `${values[0] ?? 'FAIL'}: ${await this.#why(values[0] ?? '')}` };
      this.#learned = { name, before };
      this.#show(name);
    } catch (failure) {
      this.#say(`${failureText(failure)}. For one more sample of an object write its name first; then click again.`);
    }
    this.#busy = false;
  }

  /** @param {string} name */
  #show(name) {
    const isNew = name === this.#provisional();
    const named = element('input', {
      id: 'new-name',
      required: true,
      maxlength: 64,
      spellcheck: 'false',
      pattern: '[A-Za-z][A-Za-z0-9\\-]*',
      title: 'a letter, then letters, digits and hyphens',
      value: isNew ? '' : name,
    });
    const known = this.#objects.names();
    /** @param {string} one */
    const take = (one) => element('button', { type: 'button', class: 'small', onclick: () => (named.value = one) }, one);
    const free = isNew ? usual.filter((one) => !known.includes(one)).map(take) : [];
    const form = element(
      'form',
      { class: 'row' },
      element('label', { for: 'new-name' }, 'Name it'),
      named,
      ...free,
      element('button', { type: 'submit', class: 'strong' }, 'Accept'),
      element('button', { type: 'button', id: 'reject', onclick: () => this.#reject() }, 'Reject'),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#accept(named.value);
    });
    this.#window.replaceChildren(this.#sample, form);
    this.#showSample();
    this.#window.hidden = false;
    this.#say('Learned. Accept it under a name, or reject it.');
    named.focus();
  }

  // The reply comes before the facts of what was learned, or after.
  #showSample() {
    const { name, before } = this.#learned ?? { name: '', before: 0 };
    const sample = this.#objects.newest(name);
    if (!sample || sample.num <= before) return this.#sample.replaceChildren();
    const isNew = name === this.#provisional();
    /** @type {[label: string, value: string][]} */
    const rows = [['Name', isNew ? 'to be named' : name], ...sample.parameters, ['Num', String(sample.num)]];
    this.#sample.replaceChildren(
      templatePicture(sample.picture, sample.tone, `What was learned as ${name}`),
      element(
        'dl',
        { class: 'parameters' },
        ...rows.flatMap(([label, value]) => [element('dt', {}, label), element('dd', {}, value)]),
      ),
      ...this.#objects.alike(name).map((sentence) => element('p', { class: 'warn' }, clipped(sentence))),
    );
  }

  // One at a time: a click meanwhile would be taken under the name that is just being given.
  /** @param {string} saying @param {(learned: string) => Promise<unknown>} work @param {string} done */
  async #end(saying, work, done) {
    const learned = this.#learned;
    if (this.#busy || !learned) return;
    this.#busy = true;
    this.#say(saying);
    let sentence = done;
    try {
      await work(learned.name);
      this.#learned = null;
      this.#window.hidden = true;
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
      if (name !== learned) await this.#ask(sym('rename'), learned, name);
      this.#learned = { name, before: 0 };
      await this.#ask(sym('accept'), name);
    };
    return this.#end(`Accepting ${name} …`, work, `${name} is accepted. Click on the next mark.`);
  }
  #reject() {
    return this.#end('Rejecting …', (learned) => this.#ask(sym('reject'), learned), 'Rejected: nothing was learned.');
  }
}
