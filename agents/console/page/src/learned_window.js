// What was just learned, before it is named: its template, its parameters (Table C.1), its look-alikes, and a field for
// the name under which it is accepted.
//
//   const learned = new LearnedWindow(objects, { accept: (name) => ..., reject: () => ... });
//   learned.open({ name, isNew: true, before: 0 });       the newest sample of that name, once its number is above `before`
//   learned.hide();

import { clipped, element } from './dom.js';
import { endEffector } from './learned_objects.js';
import { templatePicture } from './template_picture.js';

/** @import { LearnedObjects, Sample } from './learned_objects.js' */

/** `isNew`: nobody has named it yet.
 * @typedef {{ name: string, isNew: boolean, before: number }} Learned */

// What marks are mostly called: a press names one without a keyboard.
const usual = [endEffector, 'circle', 'triangle', 'square', 'cross'];

// Of every field that takes a name.
export const nameRules = {
  maxlength: 64,
  spellcheck: 'false',
  pattern: '[A-Za-z][A-Za-z0-9\\-]*',
  title: 'a letter, then letters, digits and hyphens',
};

/** @param {Learned} learned @param {Sample} sample */
function parameterList({ name, isNew }, sample) {
  /** @type {[label: string, value: string][]} */
  const rows = [['Name', isNew ? 'to be named' : name], ...sample.parameters, ['Num', String(sample.num)]];
  const items = rows.flatMap(([label, value]) => [element('dt', {}, label), element('dd', {}, value)]);
  return element('dl', { class: 'parameters' }, ...items);
}

export class LearnedWindow {
  #objects;
  #ends;
  /** @type {Learned | null} */
  #learned = null;
  #sample = element('div', { class: 'learned-sample' });
  panel = element('div', { class: 'learned-window', id: 'learned-window', role: 'group', hidden: true });

  /** @param {LearnedObjects} objects @param {{ accept: (name: string) => void, reject: () => void }} ends */
  constructor(objects, ends) {
    this.#objects = objects;
    this.#ends = ends;
  }

  /** @param {Learned} learned */
  open(learned) {
    this.#learned = learned;
    const field = element('input', { id: 'new-name', required: true, value: learned.isNew ? '' : learned.name, ...nameRules });
    this.panel.replaceChildren(this.#sample, this.#form(field, learned.isNew));
    this.showSample();
    this.panel.hidden = false;
    field.focus();
  }
  hide() {
    this.#learned = null;
    this.panel.hidden = true;
  }
  // What is shown has that name now.
  /** @param {string} name */
  rename(name) {
    this.#learned = { name, isNew: false, before: 0 };
  }

  // The reply to LEARN comes before the facts of what was learned, or after.
  showSample() {
    const learned = this.#learned;
    const sample = learned && this.#objects.newest(learned.name);
    if (!learned || !sample || sample.num <= learned.before) return this.#sample.replaceChildren();
    this.#sample.replaceChildren(
      templatePicture(sample.picture, sample.tone, `What was learned as ${learned.name}`),
      parameterList(learned, sample),
      ...this.#objects.alike(learned.name).map((sentence) => element('p', { class: 'warn' }, clipped(sentence))),
    );
  }

  /** @param {HTMLInputElement} field @param {boolean} isNew */
  #form(field, isNew) {
    const known = this.#objects.names();
    /** @param {string} name */
    const take = (name) => element('button', { type: 'button', class: 'small', onclick: () => (field.value = name) }, name);
    const free = isNew ? usual.filter((name) => !known.includes(name)).map(take) : [];
    const form = element(
      'form',
      { class: 'row' },
      element('label', { for: field.id }, 'Name it'),
      field,
      ...free,
      element('button', { type: 'submit', class: 'strong' }, 'Accept'),
      element('button', { type: 'button', id: 'reject', onclick: () => this.#ends.reject() }, 'Reject'),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#ends.accept(field.value);
    });
    return form;
  }
}
