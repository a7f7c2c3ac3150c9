// What was opened in the picture of the work: an entry for each of the marks that were pressed together.
//
//   const opened = new OpenedMarks(entryOf);      who makes the story's entry of a fact of the story
//   opened.open(marks);

import { clipped, clock, element } from './dom.js';
import { fact } from './live_answers.js';
import { toldBy } from './provenance.js';

/** @import { Mark } from './work_marks.js' */
/** @import { Answer } from './messages' */

const most = 20;

// What is no entry of the story.
/** @param {Mark} mark */
function plainEntry({ answer: { ids, facts }, label }) {
  const summary = element('summary', {}, element('time', {}, clock(facts[0].when)), clipped(label));
  return element('details', {}, summary, element('p', { class: 'quiet' }, toldBy(ids[0], facts[0])));
}

export class OpenedMarks {
  #entryOf;
  panel = element('div', { class: 'timeline', id: 'opened', hidden: true });

  /** @param {(answer: Answer) => HTMLDetailsElement} entryOf */
  constructor(entryOf) {
    this.#entryOf = entryOf;
  }

  /** @param {Mark[]} marks */
  open(marks) {
    const close = element('button', { type: 'button', class: 'small', onclick: () => (this.panel.hidden = true) }, 'Close');
    const entries = marks.slice(0, most).map((mark) => (fact(mark.answer)[0].name === 'event' ? this.#entryOf(mark.answer) : plainEntry(mark)));
    const more = marks.length > most ? [element('p', { class: 'quiet' }, `and ${marks.length - most} more`)] : [];
    this.panel.replaceChildren(close, ...entries, ...more);
    this.panel.hidden = false;
    entries[0].open = true;
  }
}
