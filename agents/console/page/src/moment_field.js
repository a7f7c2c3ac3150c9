// A time that is typed: hh:mm or hh:mm:ss of today, or of another day where there is anything as old.
//
//   const field = new MomentField((moment) => ...);        microseconds; who goes there
//   field.since(first);                                    nothing is older
//   field.show(moment);                                    what is shown now; null: now

import { clock, element } from './dom.js';

const time = /^\s*(\d{1,2}):(\d{2})(?::(\d{2}))?\s*$/;

/** @param {Date} day */
const dateOf = (day) => [day.getFullYear(), day.getMonth() + 1, day.getDate()].map((part) => String(part).padStart(2, '0')).join('-');
const today = () => dateOf(new Date());
/** @param {number} moment */
const dayOf = (moment) => dateOf(new Date(moment / 1000));

// With its date, where that is not today's.
/** @param {number} moment */
export const timeOf = (moment) => (dayOf(moment) === today() ? clock(moment) : `${dayOf(moment)} ${clock(moment)}`);

// Why a time that was typed is none, or the moment.
/** @param {string} typed @param {string} date @param {number} first @returns {{ wrong: string } | { moment: number }} */
export function momentIn(typed, date, first) {
  const [, hours, minutes, seconds] = typed.match(time)?.map(Number) ?? [];
  if (hours === undefined || hours > 23 || minutes > 59 || seconds > 59) return { wrong: 'write a time as 14:03 or 14:03:20' };
  const [year, month, day] = (date || today()).split('-').map(Number);
  const moment = new Date(year, month - 1, day, hours, minutes, seconds || 0).getTime() * 1000;
  if (moment > Date.now() * 1000) return { wrong: `${timeOf(moment)} is yet to come` };
  if (moment < first) return { wrong: `nothing is known from before ${timeOf(first)}` };
  return { moment };
}

export class MomentField {
  #first = 0;
  #typing = false; // a time that is not gone to yet
  #time = element('input', { id: 'moment-time', size: 8, maxlength: 8, placeholder: 'hh:mm:ss', spellcheck: 'false', 'aria-label': 'Time of day' });
  #date = element('input', { id: 'moment-date', type: 'date', 'aria-label': 'Day', hidden: true });
  #go = element('button', { type: 'submit' }, 'Go to');
  controls = [this.#time, this.#date, this.#go];
  form = element('form', { class: 'row', autocomplete: 'off' }, this.#date, this.#time, this.#go);

  /** @param {(moment: number) => void} goTo */
  constructor(goTo) {
    this.form.addEventListener('submit', (event) => {
      event.preventDefault();
      const typed = momentIn(this.#time.value, this.#date.value, this.#first);
      this.#time.setCustomValidity('wrong' in typed ? typed.wrong : '');
      if (!('moment' in typed)) return this.#time.reportValidity();
      this.#typing = false;
      goTo(typed.moment);
    });
    this.#time.addEventListener('input', () => {
      this.#typing = true;
      this.#time.setCustomValidity('');
    });
    this.#time.addEventListener('blur', () => (this.#typing = false));
  }

  /** @param {number} first */
  since(first) {
    this.#first = first;
    this.#date.hidden = dayOf(first) === today();
    this.#date.min = dayOf(first);
    this.#date.max = today();
    if (!this.#date.value) this.#date.value = today();
  }

  // Not while somebody types.
  /** @param {number | null} moment */
  show(moment) {
    if (this.#typing || document.activeElement === this.#date) return;
    this.#time.value = moment === null ? '' : clock(moment);
    this.#date.value = moment === null ? today() : dayOf(moment);
  }
}
