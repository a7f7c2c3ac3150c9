// The answers to a question as a table that is drawn anew whenever one comes or goes. What came since is marked; of each
// answer it shows on demand because of what its facts were told.
//
//   const table = new AnswerTable(connection);
//   table.begin();                   another question
//   table.show(answers);

import { clipped, element } from './dom.js';
import { provenance, toldBy } from './provenance.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer } from './messages' */

export const mostRows = 200;

/** @param {Answer} answer */
const idsOf = (answer) => answer.ids.join();

// A number is not broken in its middle, as names may be.
/** @param {string} value */
function cell(value) {
  const isNumber = value.length <= 24 && value !== '' && Number.isFinite(Number(value));
  return element('td', { class: isNumber ? 'number' : '' }, clipped(value, 160));
}

/** @param {Answer} answer @param {string[]} variables @param {boolean} isNew */
function row(answer, variables, isNew) {
  const told = answer.facts.map((one, i) => toldBy(answer.ids[i], one));
  const values = variables.length ? variables.map((name) => answer.bindings[name] ?? '') : [answer.facts[0]?.text ?? 'yes'];
  const because = element('button', { type: 'button', class: 'because', 'data-ids': idsOf(answer) }, 'Because …');
  return element(
    'tr',
    { title: told.join('\n'), class: isNew ? 'new' : '' },
    ...values.map(cell),
    element('td', {}, because),
  );
}

/** @param {Answer[]} answers @param {(answer: Answer) => boolean} isNew */
function table(answers, isNew) {
  if (answers.length === 0) return element('p', { class: 'quiet' }, 'nothing, now');
  const variables = Object.keys(answers[0].bindings);
  const heads = (variables.length ? variables : ['fact']).map((name) => element('th', {}, name));
  const rows = answers.map((answer) => row(answer, variables, isNew(answer)));
  return element('table', {}, element('thead', {}, element('tr', {}, ...heads, element('td', {}))), element('tbody', {}, ...rows));
}

export class AnswerTable {
  #connection;
  /** @type {Answer[]} */
  #shown = [];
  panel = element('div', { class: 'scroll', id: 'answers' });
  because = element('div', { id: 'because', role: 'group', 'aria-label': 'Reasons', tabindex: 0, hidden: true });

  /** @param {Connection} connection */
  constructor(connection) {
    this.#connection = connection;
    // The rows are drawn anew whenever something changes: what is pressed counts, not what is let go.
    this.panel.addEventListener('pointerdown', (event) => this.#explain(event));
    this.panel.addEventListener('keydown', (event) => ['Enter', ' '].includes(event.key) && this.#explain(event));
  }

  begin() {
    this.#shown = [];
    this.panel.replaceChildren();
    this.because.hidden = true;
  }
  /** @param {Answer[]} answers */
  show(answers) {
    const before = new Set(this.#shown.map(idsOf));
    this.#shown = answers.slice(0, mostRows);
    this.panel.replaceChildren(table(this.#shown, (answer) => before.size > 0 && !before.has(idsOf(answer))));
  }

  /** @param {Event} event */
  async #explain(event) {
    const pressed = event.target instanceof Element ? event.target.closest('button.because') : null;
    const ids = pressed?.getAttribute('data-ids');
    const answer = this.#shown.find((one) => idsOf(one) === ids);
    if (!answer) return;
    const trees = answer.facts.map((one, i) => provenance(this.#connection, answer.ids[i], one));
    this.because.replaceChildren(...(await Promise.all(trees)));
    this.because.hidden = false;
  }
}
