// What is wanted: goals typed, and what became of the newest.

import { failureText, find } from './dom.js';
import { completes } from './completion.js';
import { fact } from './live_answers.js';
import { isNamed } from './learned_objects.js';
import { nextWords } from './goal_words.js';
import { Reasons } from './reasons.js';
import { showTowers } from './towers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Permission } from './permission.js' */
/** @import { Answer, Failure, Form } from './messages' */

const carried = 'end-effector';

// What is wrong with what was typed is marked in the field: `goal:LINE:COLUMN`, of its one line.
/** @param {HTMLInputElement} field @param {Failure} failure */
function markPlace(field, failure) {
  const column = Number(failure.place?.match(/^goal:1:(\d+)/)?.[1] ?? 0);
  field.setAttribute('aria-invalid', 'true');
  if (column === 0) return;
  const word = field.value.slice(column - 1).match(/^[()]|^[^\s()]+/)?.[0] ?? ' ';
  field.focus();
  field.setSelectionRange(column - 1, column - 1 + word.length);
}

// The domain's predicates: what whoever pursues goals both posts and reads of symbols alone, and keeps nowhere.
/** @param {Answer[]} contracts */
function predicatesIn(contracts) {
  /** @type {Map<string, number>} */
  const found = new Map();
  for (const [, , contract] of contracts.map(fact)) {
    /** @param {string} name @returns {Form[]} */
    const part = (name) => contract.filter((/** @type {Form} */ each) => text(each[0]) === name).flatMap((/** @type {Form} */ each) => each.slice(1));
    if (!part('offers').some((offer) => text(offer[0]) === 'goal')) continue;
    const read = new Set(part('reads').map(text));
    for (const [, name, args, ...rest] of part('posts')) {
      const isPredicate = read.has(text(name)) && args.every((/** @type {Form} */ [, type]) => text(type) === 'symbol');
      if (isPredicate && !rest.some((option) => text(option[0]) === 'durable')) found.set(text(name), args.length);
    }
  }
  return found;
}

/** @param {Connection} connection @param {Permission} permission */
export function showWant(connection, permission) {
  const towers = showTowers();
  const answer = find('goal-answer');
  const goalText = find('goal-text');
  /** @param {string} sentence */
  const say = (sentence, kind = '') => {
    answer.hidden = false;
    answer.className = kind;
    answer.textContent = sentence;
  };

  /** @param {string} typed */
  const accepted = async (typed) => {
    say('asking …');
    goalText.removeAttribute('aria-invalid');
    try {
      const [number] = await connection.goal(typed, (end) => {
        if ('error' in end) say(failureText(end.error), 'bad');
        else say(`goal ${number} ${end.values[0]}`, end.values[0] === 'reached' ? 'good' : '');
      });
      say(`goal ${number} accepted`);
    } catch (failure) {
      say(failureText(failure), 'bad');
      markPlace(goalText, /** @type {Failure} */ (failure));
    }
  };
  find('goal-form').addEventListener('submit', (event) => {
    event.preventDefault();
    accepted(goalText.value);
  });
  find('cancel').addEventListener('click', async () => {
    try {
      await connection.request('coordinator', '(cancel)');
    } catch (failure) {
      say(failureText(failure), 'bad');
    }
  });

  const reasons = new Reasons('why-want');
  find('goal-form').append(reasons.note);
  let pursued = false;
  const gate = () => {
    reasons.set('Go', [find('go')], permission.command('goal'));
    reasons.set('Cancel', [find('cancel')], permission.command('request') || (pursued ? '' : 'no goal is running'));
  };
  permission.onChange(gate);

  connection.follow('(goal-state ?n ?state ?detail)', (answers) => {
    const newest = answers.map(fact).toSorted((a, b) => b[1] - a[1])[0];
    const chip = find('goal-chip');
    chip.hidden = !newest;
    const state = newest ? text(newest[2]) : '';
    pursued = state === 'running';
    document.body.dataset.goal = state;
    gate();
    if (!newest) return;
    chip.textContent = `goal ${newest[1]}: ${state}`;
    chip.className = `chip ${state === 'reached' ? 'good' : state === 'running' ? 'busy' : 'warn'}`;
  });

  // What may be typed: the domain's predicates, of what has been learned and of what else they were seen to hold.
  /** @type {string[]} */
  let learned = [];
  /** @type {string[]} */
  let placed = [];
  /** @type {Map<string, number>} */
  let predicates = new Map();
  connection.follow('(contract ?name ?form)', (answers) => (predicates = predicatesIn(answers)));
  connection.follow('(believed ?fact)', (answers) => (placed = answers.flatMap((believed) => fact(believed)[1].slice(1).map(text))));
  connection.follow('(learned ?eyes ?name 1 ? ? ? ? ? ?)', (answers) => {
    learned = answers.map((one) => text(fact(one)[2])).filter((name) => name !== carried && isNamed(name));
    towers.setNames([...new Set(learned)].slice(0, 12));
  });
  completes(goalText, (source) => nextWords(source, { predicates, names: [...new Set([...learned, ...placed])].sort() }));
}
