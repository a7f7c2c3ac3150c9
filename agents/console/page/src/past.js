// Back into the journal, by a slider, a time that is typed, or from entry to entry of the story: what was known then, in
// the same views, while the cell goes on. Its board must keep a journal. STOP is of now.

import { element, failureText, find } from './dom.js';
import { MomentField, timeOf } from './moment_field.js';
import { Reasons } from './reasons.js';

/** @import { Connection } from './connection.js' */
/** @import { Images } from './images.js' */
/** @import { Permission } from './permission.js' */
/** @import { Answer, Failure } from './messages' */
/** @import { WorkEntries } from './work_entries.js' */

const second = 1e6; // microseconds
const growth = 1000; // milliseconds between two steps of the slider's end, which is now
// Milliseconds between two moments that are shown. For each, all that is followed is asked anew, and the console ends a
// connection on which more than 400 messages come in a second.
const between = 500;

/** @typedef {{ connection: Connection, permission: Permission, entries: WorkEntries, images: Images }} Around */

/** @param {(step: -1 | 1) => void} go */
function entryButtons(go) {
  /** @param {-1 | 1} step @param {string} sign @param {string} label */
  const button = (step, sign, label) => element('button', { type: 'button', 'aria-label': label, title: label, onclick: () => go(step) }, sign);
  return [button(-1, '◂ Entry', 'The entry of the story before'), button(1, 'Entry ▸', 'The entry of the story after')];
}

class Past {
  #around;
  #first = 0; // when the oldest that is known was told
  #newest = 0;
  #asked = false; // whether there is a journal
  /** @type {number | null} */
  #moment = null; // that was chosen last
  #shown = -between; // when one was, by the page's own clock
  /** @type {number | undefined} */
  #later; // the timer of one that is yet to be shown
  #none = ''; // why there is no past
  #slider = element('input', { type: 'range', id: 'moment', min: 0, max: 1, step: 1, value: 1, 'aria-label': 'Back in time, by seconds' });
  #note = element('output', { id: 'moment-note', for: 'moment' }, 'now');
  #now = element('button', { type: 'button', id: 'back-to-now', disabled: true, onclick: () => this.goTo(null) }, 'Now');
  #field = new MomentField((moment) => this.goTo(moment));
  #steps = entryButtons((step) => this.#goToEntry(step));
  #reasons = new Reasons('why-no-past');

  /** @param {Around} around */
  constructor(around) {
    this.#around = around;
    const { connection, permission } = around;
    find('past').append(element('label', { for: 'moment' }, 'Time'), this.#slider, ...this.#steps, this.#field.form, this.#note, this.#now, this.#reasons.note);
    this.#slider.addEventListener('input', () => (this.#note.textContent = timeOf(this.#chosen() ?? Date.now() * 1000)));
    this.#slider.addEventListener('change', () => this.goTo(this.#chosen()));
    this.#slider.addEventListener('keydown', (event) => this.#key(event));
    connection.followAlways('(agent ?name ?kind ?host)', (answers) => this.#hear(answers));
    connection.followAlways('(event ?n ?kind ?sentence ?detail)', (answers) => this.#hear(answers));
    permission.onChange(() => this.#gate());
    setInterval(() => this.#grow(), growth);
  }

  // Of several in quick succession the last is shown.
  /** @param {number | null} moment microseconds; null: now */
  goTo(moment) {
    this.#moment = moment;
    this.#put(moment);
    this.#note.textContent = `${moment === null ? 'now' : timeOf(moment)} …`;
    clearTimeout(this.#later);
    const wait = this.#shown + between - performance.now();
    if (wait > 0) this.#later = setTimeout(() => this.#show(moment), wait);
    else this.#show(moment);
  }
  /** @param {number | null} moment */
  async #show(moment) {
    const { connection, permission, images } = this.#around;
    this.#shown = performance.now();
    document.body.classList.toggle('past', moment !== null);
    permission.set({ past: moment !== null });
    this.#now.disabled = moment === null;
    if (moment === null) this.#note.textContent = 'now';
    images.showMoment(moment);
    const failure = await connection.showMoment(moment);
    // Another moment may have been chosen meanwhile.
    if (moment === null || this.#moment !== moment) return;
    this.#note.textContent = failure ? failureText(failure) : `as it was at ${timeOf(moment)}`;
  }

  // Of the slider; null: its end, which is now.
  #chosen() {
    const value = Number(this.#slider.value);
    return value === Number(this.#slider.max) ? null : this.#first + value * second;
  }
  /** @param {number | null} moment */
  #put(moment) {
    const length = Math.max(1, Math.ceil((Date.now() * 1000 - this.#first) / second));
    this.#slider.max = String(length);
    this.#slider.value = String(moment === null ? length : Math.min(Math.max(Math.round((moment - this.#first) / second), 0), length - 1));
    this.#slider.setAttribute('aria-valuetext', moment === null ? 'now' : timeOf(moment));
    this.#field.show(moment);
  }
  // Not under a hand.
  #grow() {
    if (!this.#slider.matches(':active')) this.#put(this.#moment);
  }

  /** @param {-1 | 1} step */
  #goToEntry(step) {
    const moment = this.#moment ?? Infinity;
    const times = this.#around.entries.until(Infinity).map(({ facts }) => facts[0].when);
    const there = step < 0 ? times.findLast((when) => when < moment) : times.find((when) => when > moment);
    if (there !== undefined || step > 0) this.goTo(there ?? null);
  }
  // The arrow keys are the slider's own: a second each.
  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.key !== 'PageUp' && event.key !== 'PageDown') return;
    event.preventDefault();
    this.#goToEntry(event.key === 'PageUp' ? 1 : -1);
  }

  // As far back as anything that is known was told.
  /** @param {Answer[]} answers */
  #hear(answers) {
    const times = answers.map(({ facts }) => facts[0].when);
    if (times.length === 0) return;
    this.#first = Math.min(this.#first || Infinity, ...times);
    this.#newest = Math.max(this.#newest, ...times);
    this.#field.since(this.#first);
    this.#gate();
  }
  // Asked once a connection: what was known when the newest of it was told.
  async #askWhether() {
    this.#asked = true;
    try {
      await this.#around.connection.askThen('(agent ?name ?kind ?host)', this.#newest);
      this.#none = '';
    } catch (failure) {
      this.#none = /** @type {Failure} */ (failure).sentence ?? failureText(failure);
    }
    this.#gate();
  }
  #gate() {
    const { permission } = this.#around;
    if (!permission.live) this.#asked = false;
    else if (!this.#asked && this.#newest) this.#askWhether();
    const why = permission.line || (this.#newest ? this.#none : 'nothing is known yet');
    this.#reasons.set('Back in time', [this.#slider, ...this.#steps, ...this.#field.controls], why);
  }
}

// Answers what goes to a moment that is named.
/** @param {Around} around */
export function showPast(around) {
  const past = new Past(around);
  /** @param {number} moment */
  return (moment) => past.goTo(moment);
}
