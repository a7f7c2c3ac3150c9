// Which controls are off, and why, in words that everybody can read: a tooltip needs a mouse.
//
//   const reasons = new Reasons('why-drive');              its element's id
//   panel.append(reasons.note);
//   reasons.set('Home and Ready', [home, ready], 'Take the arm in hand first');       '' where they may be pressed

import { element } from './dom.js';

/** @typedef {HTMLButtonElement | HTMLInputElement} Control */

export class Reasons {
  note;
  /** @type {Map<string, string>} */
  #reasons = new Map(); // by what is off

  /** @param {string} id */
  constructor(id) {
    this.note = element('p', { class: 'reasons', id, hidden: true });
  }

  /** @param {string} what @param {Control[]} controls @param {string} reason */
  set(what, controls, reason) {
    for (const control of controls) {
      control.dataset.title ??= control.title;
      control.disabled = reason !== '';
      control.title = reason || control.dataset.title;
      if (reason) control.setAttribute('aria-describedby', this.note.id);
      else control.removeAttribute('aria-describedby');
    }
    const said = controls.length > 0 ? reason : '';
    if ((this.#reasons.get(what) ?? '') === said) return;
    this.#reasons.set(what, said);
    this.#show();
  }

  // What is off for the same reason stands together.
  #show() {
    /** @type {Map<string, string[]>} */
    const off = new Map();
    for (const [what, reason] of this.#reasons) if (reason) off.set(reason, [...(off.get(reason) ?? []), what]);
    this.note.replaceChildren(
      ...[...off].map(([reason, parts]) =>
        element('span', {}, element('strong', {}, parts.join(', ')), `: ${reason}. `),
      ),
    );
    this.note.hidden = off.size === 0;
  }
}
