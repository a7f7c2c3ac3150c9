// Because of what a fact was told: the fact, its reasons, and theirs, as a small graph from above to below.

import { clipped, clock, element } from './dom.js';
import { fact } from './live_answers.js';
import { sym, text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer, Datum, Form, ToldFact } from './messages' */

const deepest = 4;
const most = 60;

/** @param {Answer} contract @returns {Form[]} */
const relationsIn = (contract) =>
  fact(contract)[2]
    .filter((/** @type {Datum} */ part) => Array.isArray(part) && text(part[0]) === 'posts')
    .flatMap((/** @type {Form} */ part) => part.slice(1))
    .filter((/** @type {Form} */ relation) => Array.isArray(relation?.[2]));

// A board has no question for a fact's number: what agents post by their contracts is asked for.
/** @param {Connection} connection */
async function factsByNumber(connection) {
  const contracts = await connection.ask([sym('contract'), sym('?'), sym('?form')]);
  const widths = new Map(contracts.flatMap(relationsIn).map(([, name, args]) => [text(name), args.length]));
  const found = new Map();
  for (const [name, width] of widths) {
    const answers = await connection.ask([sym(name), ...Array(width).fill(sym('?'))]);
    for (const { ids, facts } of answers) found.set(ids[0], facts[0]);
  }
  return found;
}

/** @param {number} id @param {ToldFact | undefined} told */
function node(id, told) {
  if (!told) return element('span', { class: 'fact gone' }, `fact ${id}, which is not there any more`);
  return element(
    'span',
    { class: 'fact' },
    element('code', {}, clipped(told.text, 120)),
    element('small', { class: 'quiet' }, `fact ${id}, by ${told.teller} at ${clock(told.when)}`),
  );
}

/** @param {number} id @param {ToldFact | undefined} told @param {Map<number, ToldFact>} found @param {number[]} drawn @param {number} depth @returns {HTMLElement} */
function tree(id, told, found, drawn, depth) {
  drawn.push(id);
  const reasons = told && depth < deepest ? told.because : [];
  const branches = reasons
    .slice(0, Math.max(0, most - drawn.length))
    .map((reason) => tree(reason, found.get(reason), found, drawn, depth + 1));
  const below = branches.length ? element('ul', { 'aria-label': 'because of' }, ...branches) : null;
  return element('li', {}, node(id, told), below);
}

// As it is told now: a reason that has gone since is said to have.
/** @param {Connection} connection @param {number} id @param {ToldFact} told */
export async function provenance(connection, id, told) {
  const found = await factsByNumber(connection);
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
