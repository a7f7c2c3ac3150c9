// The story: over time as a picture, and as a list, newest first: what was wanted, planned, done, seen otherwise. An entry
// opens its detail, what it was told because of, and what was seen then; above them the coordinator says why it does
// what it does.

import { arrange, clipped, clock, eachFrame, element, failureText, find } from './dom.js';
import { entryWhy } from './entry_why.js';
import { fact } from './live_answers.js';
import { goalHistory } from './goal_history.js';
import { keptPicture } from './kept_picture.js';
import { planChange, planIn } from './plan_change.js';
import { provenanceButton, toldBy } from './provenance.js';
import { Reasons } from './reasons.js';
import { showWork } from './work.js';
import { text, write } from './datum.js';
import { keyOf } from './work_entries.js';

/** @import { Connection } from './connection.js' */
/** @import { Images } from './images.js' */
/** @import { Permission } from './permission.js' */
/** @import { WorkEntries } from './work_entries.js' */
/** @import { Answer, Datum } from './messages' */

const shown = 200;

// The plan of the same goal before this one, and what of it was begun until then; null for a goal's first.
/** @param {Answer[]} events @param {number} number @param {Datum} goal */
function planBefore(events, number, goal) {
  const earlier = events.map(fact).filter((event) => event[1] < number);
  const made = earlier.filter((event) => planIn(event[4])?.goal === goal).toSorted((a, b) => b[1] - a[1])[0];
  const plan = made && planIn(made[4]);
  if (!plan) return null;
  const begun = earlier.filter((event) => event[1] > made[1] && text(event[2]) === 'operation').map((event) => write(event[4]));
  return { operations: plan.operations, begun: new Set(begun) };
}

/** @param {Answer[]} events @param {number} number @param {Datum} detail */
function detailOf(events, number, detail) {
  const plan = planIn(detail);
  const before = plan && planBefore(events, number, plan.goal);
  if (before) return planChange(before.operations, plan.operations, before.begun);
  return element('pre', {}, clipped(write(detail), 4000));
}

/** @typedef {{ connection: Connection, permission: Permission, entries: WorkEntries, images: Images }} Around */

/** @param {Around} around @param {(moment: number) => void} goTo @param {Answer[]} events @param {Answer} answer */
function entryOf({ connection, images }, goTo, events, answer) {
  const [, number, kind, sentence, detail] = fact(answer);
  const told = answer.facts[0];
  const summary = element(
    'summary',
    {},
    element('time', {}, clock(told.when)),
    element('span', { class: `kind ${text(kind)}` }, text(kind)),
    element('span', {}, clipped(text(sentence))),
  );
  const seen = element('div', {});
  const why = element('div', {});
  /** @param {Event & { target: HTMLDetailsElement }} event */
  const open = async ({ target }) => {
    if (!target.open) return;
    seen.replaceChildren(keptPicture(connection, images.telling(), told.when));
    why.replaceChildren(await entryWhy(connection, events, answer));
  };
  return element(
    'details',
    { 'data-number': number, ontoggle: open },
    summary,
    element('p', { class: 'quiet' }, toldBy(answer.ids[0], told)),
    element('button', { type: 'button', class: 'small', onclick: () => goTo(told.when) }, 'Show all as it was then'),
    seen,
    why,
    provenanceButton(connection, answer.ids[0], told),
    detailOf(events, number, detail),
  );
}

/** @param {Around} around @param {(moment: number) => void} goTo */
export function showStory(around, goTo) {
  const { connection, permission, entries } = around;
  const list = element('div', { class: 'timeline' });
  const why = element('pre', { class: 'answer', hidden: true });
  const ask = async () => {
    why.hidden = false;
    try {
      why.textContent = (await connection.request('coordinator', '(why)'))
        .map((line) => clipped(line, 1000))
        .join('\n');
    } catch (failure) {
      why.textContent = failureText(failure);
    }
  };
  const told = () => entries.until(connection.moment ?? Infinity);
  /** @param {Answer} answer */
  const entry = (answer) => entryOf(around, goTo, told(), answer);
  const work = showWork(connection, entries, entry);
  const question = element('button', { type: 'button', id: 'why', onclick: ask }, 'Why this, now?');
  const reasons = new Reasons('why-not-asked');
  permission.onChange(() => reasons.set('Why this', [question], permission.line || permission.right('request')));
  find('story').append(
    element('div', { class: 'row' }, question, reasons.note),
    why,
    work.panel,
    goalHistory(connection),
    list,
  );

  /** @type {Map<string, HTMLDetailsElement>} */
  const made = new Map();
  /** @param {Answer} answer */
  const madeOnce = (answer) => {
    const there = made.get(keyOf(answer)) ?? entry(answer);
    made.set(keyOf(answer), there);
    return there;
  };
  const draw = eachFrame(() => {
    const newest = told().reverse().slice(0, shown);
    const keys = new Set(newest.map(keyOf));
    for (const key of made.keys()) if (!keys.has(key)) made.delete(key);
    arrange(list, newest.map(madeOnce));
    work.draw();
  });
  entries.onChange(draw);
}
