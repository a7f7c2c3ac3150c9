// What is wanted: goals typed or sketched, and what became of the newest.

import { failureText, find } from './dom.js';
import { completes } from './completion.js';
import { fact } from './live_answers.js';
import { GoalVocabulary } from './goal_vocabulary.js';
import { nextWords } from './goal_words.js';
import { Reasons } from './reasons.js';
import { showTowers } from './towers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Permission } from './permission.js' */
/** @import { Failure } from './messages' */

const mostInSketch = 12;

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

/** @param {string} sentence */
function say(sentence, kind = '') {
  const answer = find('goal-answer');
  answer.hidden = false;
  answer.className = kind;
  answer.textContent = sentence;
}

// Says what becomes of it.
/** @param {Connection} connection @param {HTMLInputElement} field */
async function pursue(connection, field) {
  say('asking …');
  field.removeAttribute('aria-invalid');
  try {
    const [number] = await connection.goal(field.value, (end) => {
      if ('error' in end) say(failureText(end.error), 'bad');
      else say(`goal ${number} ${end.values[0]}`, end.values[0] === 'reached' ? 'good' : '');
    });
    say(`goal ${number} accepted`);
  } catch (failure) {
    say(failureText(failure), 'bad');
    markPlace(field, /** @type {Failure} */ (failure));
  }
}

/** @param {Connection} connection */
async function cancel(connection) {
  try {
    await connection.request('coordinator', '(cancel)');
  } catch (failure) {
    say(failureText(failure), 'bad');
  }
}

// The state of the newest goal; '' where there is none.
/** @param {Connection} connection @param {(state: string) => void} changed */
function showNewest(connection, changed) {
  connection.follow('(goal-state ?n ?state ?detail)', (answers) => {
    const newest = answers.map(fact).toSorted((a, b) => b[1] - a[1])[0];
    const state = newest ? text(newest[2]) : '';
    const chip = find('goal-chip');
    chip.hidden = !newest;
    document.body.dataset.goal = state;
    changed(state);
    if (!newest) return;
    chip.textContent = `goal ${newest[1]}: ${state}`;
    chip.className = `chip ${state === 'reached' ? 'good' : state === 'running' ? 'busy' : 'warn'}`;
  });
}

/** @param {Connection} connection @param {Permission} permission */
export function showWant(connection, permission) {
  const towers = showTowers();
  const field = find('goal-text');
  find('goal-form').addEventListener('submit', (event) => {
    event.preventDefault();
    pursue(connection, field);
  });
  field.addEventListener('input', () => field.removeAttribute('aria-invalid'));
  find('cancel').addEventListener('click', () => cancel(connection));

  const reasons = new Reasons('why-want');
  find('goal-form').append(reasons.note);
  let pursued = false;
  const gate = () => {
    reasons.set('Go', [find('go')], permission.command('goal'));
    reasons.set('Cancel', [find('cancel')], permission.command('request') || (pursued ? '' : 'no goal is running'));
  };
  permission.onChange(gate);
  showNewest(connection, (state) => {
    pursued = state === 'running';
    gate();
  });
  const vocabulary = new GoalVocabulary(connection, (names) => towers.setNames(names.slice(0, mostInSketch)));
  completes(field, (source) => nextWords(source, vocabulary.words()));
}
