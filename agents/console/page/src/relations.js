// The relations of the board: what stands, who tells them, how many watch, and how long their facts are under way. A name
// asks for all of it.

import { asComponents } from './names.js';
import { element } from './dom.js';
import { table } from './tables.js';

/** @import { Activity } from './activity.js' */
/** @import { ShowActivity } from './feeds.js' */
/** @import { Activity as Sample, Spread } from './messages' */

const shown = 60;
const heads = ['Relation', 'Facts', 'Told/s', 'Watches', 'To board', 'To watcher', 'Told by'];

/** @param {number} microseconds */
const ms = (microseconds) => (microseconds / 1000).toFixed(microseconds < 10_000 ? 1 : 0);
/** @param {Spread | null} times */
const spread = (times) => (times ? `${ms(times.p50)} / ${ms(times.p99)}` : '–');

/** @param {Sample} sample */
function headline({ revision, facts, transactions_per_second: rate, journey }) {
  const way = journey
    ? `; a fact is committed after ${journey.committed_us} µs, acknowledged after ${journey.acknowledged_us} µs, delivered after ${journey.delivered_us} µs`
    : '';
  return `revision ${revision}, ${facts} facts, ${rate.toFixed(1)} transactions/s${way}`;
}

// `ask` asks for all of a relation; its answer says whether that is known how.
/** @param {Activity} activity @param {(name: string) => boolean} canAsk @param {(name: string) => void} ask @param {() => string} me */
export function showRelations(activity, canAsk, ask, me) {
  const note = element('p', { class: 'quiet', id: 'activity-note' }, '…');
  const relations = table({ id: 'relations' }, heads);
  // A button stays the same one while its row is drawn anew: what is pressed is then clicked.
  const buttons = new Map();
  /** @param {string} name */
  const buttonOf = (name) => {
    if (!buttons.has(name)) buttons.set(name, element('button', { type: 'button', class: 'small', onclick: () => ask(name) }, name));
    buttons.get(name).disabled = !canAsk(name);
    return buttons.get(name);
  };
  /** @type {ShowActivity} */
  const show = (sample, why) => {
    if (!sample) {
      note.textContent = why ?? '';
      return;
    }
    note.textContent = headline(sample);
    const lively = sample.relations.filter((one) => one.facts || one.told_per_second || one.watches).slice(0, shown);
    relations.fill(
      lively
        .toSorted((a, b) => a.name.localeCompare(b.name))
        .map((one) => [
          buttonOf(one.name),
          one.facts,
          one.told_per_second.toFixed(1),
          one.watches,
          spread(one.told_us),
          spread(one.delivered_us),
          asComponents(one.tellers.join(', '), me()),
        ]),
    );
  };
  const panel = element('section', { 'aria-label': 'Relations' }, element('h2', {}, 'Relations'), note, element('p', { class: 'quiet' }, 'Under way to the board and from there, in ms: the half / 99 %. A name that is off stands in no contract, so its form is not known.'), element('div', { class: 'scroll', tabindex: 0, role: 'group', 'aria-label': 'Table of relations' }, relations.panel));
  activity.shownIn(panel, show);
  return panel;
}
