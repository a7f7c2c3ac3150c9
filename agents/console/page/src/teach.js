// TRAINING: a click in the camera's image learns what is there, in the frame that was clicked. Then a window shows what
// was learned (Table C.1), and it is named and accepted, or rejected. With a name given first it becomes another sample
// of that object.

import { clipped, element, failureText } from './dom.js';
import { sym } from './datum.js';
import { templatePicture } from './template_picture.js';

const first = 'end-effector';
// What marks are mostly called, for who has a mouse alone.
const usual = [first, 'circle', 'triangle', 'square', 'cross'];

// (LEARN "name" OK) is no failure of the request where it says FAIL.
const isLearned = (values) => /^\(LEARN ".*" OK\)$/.test(values[0] ?? '');

export class Teaching {
  #ask; // (operation...) answers the values
  #objects;
  #provisional;
  #why; // the newest reason why LEARN failed
  #point = null;
  #learnedAs = '';
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
  #window = element('div', { class: 'learned-window', id: 'learned-window', role: 'group', hidden: true });

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
    objects.onChange(() => this.#showNames());
    this.#showNames();
  }

  get #on() {
    return this.training.getAttribute('aria-pressed') === 'true';
  }
  #switch(on) {
    this.training.setAttribute('aria-pressed', String(on));
    this.training.textContent = `Training: ${on ? 'on' : 'off'}`;
    document.body.classList.toggle('training', on);
    this.#showNames();
  }
  #say(sentence) {
    this.#hint.textContent = sentence;
  }

  #showNames() {
    const names = this.#objects.names().filter((name) => name !== this.#provisional());
    this.#known.replaceChildren(...names.map((name) => element('option', { value: name })));
    if (this.#point) return;
    const begin = names.includes(first) ? '' : ' Begin with the end-effector: the triangle on the gripper.';
    this.#say(this.#on ? `Click on a mark in the camera’s image.${begin}` : 'Switch training on, and click on a mark.');
    if (this.#on && begin && this.#name.value === '') this.#name.value = first;
  }

  // Answers whether the click was taken.
  take(point) {
    if (!this.#on) return false;
    if (this.#point || !this.#name.reportValidity()) return true;
    this.#learn(point, this.#name.value || this.#provisional());
    return true;
  }

  async #learn(point, name) {
    this.#point = point;
    this.#window.hidden = true;
    this.#say(`Learning what is at ${point.x}, ${point.y} of frame ${point.frame}: red while it is filled, then its border.`);
    try {
      const values = await this.#ask(sym('learn'), point.x, point.y, point.frame, name);
      if (!isLearned(values)) throw { said: `${values[0] ?? 'FAIL'}: ${this.#why() || 'no reason was told'}` };
      this.#learnedAs = name;
      this.#show(name);
    } catch (failure) {
      this.#say(`${failureText(failure)}. For one more sample of an object write its name first; then click again.`);
    }
    this.#point = null;
  }

  #show(name) {
    const sample = this.#objects.newest(name);
    const rows = [['Name', name === this.#provisional() ? 'to be named' : name], ...(sample?.parameters ?? [])];
    if (sample) rows.push(['Num', sample.num]);
    const named = element('input', {
      id: 'new-name',
      required: true,
      maxlength: 64,
      spellcheck: 'false',
      pattern: '[A-Za-z][A-Za-z0-9\\-]*',
      title: 'a letter, then letters, digits and hyphens',
      list: 'new-names',
      value: name === this.#provisional() ? '' : name,
    });
    const known = this.#objects.names();
    const free = usual.filter((one) => !known.includes(one)).map((one) => element('option', { value: one }));
    const form = element(
      'form',
      { class: 'row' },
      element('label', { for: 'new-name' }, 'Name it'),
      named,
      element('datalist', { id: 'new-names' }, ...free),
      element('button', { type: 'submit', class: 'strong' }, 'Accept'),
      element('button', { type: 'button', id: 'reject', onclick: () => this.#reject() }, 'Reject'),
    );
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#accept(named.value);
    });
    const alike = this.#objects.alike(name).map((sentence) => element('p', { class: 'warn' }, clipped(sentence)));
    this.#window.replaceChildren(
      templatePicture(sample?.picture ?? '', sample?.tone, `What was learned as ${name}`),
      element(
        'dl',
        { class: 'parameters' },
        ...rows.flatMap(([label, value]) => [element('dt', {}, label), element('dd', {}, String(value))]),
      ),
      ...alike,
      form,
    );
    this.#window.hidden = false;
    this.#say('Learned. Accept it under a name, or reject it.');
    named.focus();
  }

  async #end(work, sentence) {
    try {
      await work();
      this.#window.hidden = true;
      this.#name.value = '';
      this.#showNames();
      this.#say(sentence);
    } catch (failure) {
      this.#say(failureText(failure));
    }
  }
  #accept(name) {
    const learned = this.#learnedAs;
    return this.#end(async () => {
      if (name !== learned) await this.#ask(sym('rename'), learned, name);
      await this.#ask(sym('accept'), name);
    }, `${name} is accepted. Click on the next mark.`);
  }
  #reject() {
    return this.#end(() => this.#ask(sym('reject'), this.#learnedAs), 'Rejected: nothing was learned.');
  }
}
