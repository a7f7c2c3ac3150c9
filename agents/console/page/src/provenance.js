// Because of what a fact was told: the fact, its reasons, and theirs, as a small graph from above to below.

import { clipped, clock, element } from './dom.js';
import { fact } from './live_answers.js';
import { sym, write } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer, ToldFact } from './messages' */

const deepest = 4;
const most = 60;

/** @typedef {ToldFact & { gone?: boolean }} Reason */

// What the board says of a fact and its reasons: (provenance ROOT ID FACT TELLER WHEN BECAUSE).
/** @param {Answer} answer @returns {[id: number, told: ToldFact]} */
function reasonIn(answer) {
  const [, , id, datum, teller, when, because] = fact(answer);
  return [id, { text: write(datum), teller, when, because }];
}

// By their numbers: what stands, and what stood when the fact was told.
/** @param {Connection} connection @param {number} root @param {ToldFact} told */
async function factsBehind(connection, root, told) {
  const query = [sym('provenance'), root, ...['?id', '?fact', '?teller', '?when', '?because'].map(sym)];
  /** @type {Map<number, Reason>} */
  const found = new Map((await connection.ask(query)).map(reasonIn));
  found.set(root, told);
  const lacking = [...found.values()].some(({ because }) => because.some((reason) => !found.has(reason)));
  if (!lacking) return found;
  // Where the board keeps no journal, they are said to have gone.
  const stood = await connection.askThen(write(query), told.when).catch(() => []);
  for (const [id, reason] of stood.map(reasonIn)) {
    if (!found.has(id)) found.set(id, { ...reason, gone: true });
  }
  return found;
}

/** @param {number} id @param {Reason | undefined} told */
function node(id, told) {
  if (!told) return element('span', { class: 'fact gone' }, `fact ${id}, which is not there any more`);
  const since = told.gone ? ', gone since' : '';
  return element(
    'span',
    { class: told.gone ? 'fact gone' : 'fact' },
    element('code', {}, clipped(told.text, 120)),
    element('small', { class: 'quiet' }, `fact ${id}, by ${told.teller} at ${clock(told.when)}${since}`),
  );
}

/** @param {number} id @param {Reason | undefined} told @param {Map<number, Reason>} found @param {number[]} drawn @param {number} depth @returns {HTMLElement} */
function tree(id, told, found, drawn, depth) {
  drawn.push(id);
  const reasons = told && depth < deepest ? told.because : [];
  const branches = reasons
    .slice(0, Math.max(0, most - drawn.length))
    .map((reason) => tree(reason, found.get(reason), found, drawn, depth + 1));
  const below = branches.length ? element('ul', { 'aria-label': 'because of' }, ...branches) : null;
  return element('li', {}, node(id, told), below);
}

// A reason that has gone since is said to have.
/** @param {Connection} connection @param {number} id @param {ToldFact} told */
export async function provenance(connection, id, told) {
  const found = await factsBehind(connection, id, told);
  return element('ul', { class: 'provenance', 'aria-label': 'Because of what it was told' }, tree(id, told, found, [], 0));
}

// A button that shows it below itself; nothing where no reason was told.
/** @param {Connection} connection @param {number} id @param {ToldFact} told */
export function provenanceButton(connection, id, told) {
  if (told.because.length === 0) return null;
  const shown = element('div', {});
  const label = `Because of ${told.because.length} fact${told.because.length > 1 ? 's' : ''}`;
  const button = element('button', { type: 'button', class: 'because' }, label);
  button.addEventListener('click', async () => {
    button.disabled = true;
    shown.replaceChildren(await provenance(connection, id, told));
    button.disabled = false;
  });
  return element('div', {}, button, shown);
}

/** @param {number} id @param {ToldFact} told */
export const toldBy = (id, { teller, when }) => `fact ${id}, told by ${teller} at ${clock(when)}`;
