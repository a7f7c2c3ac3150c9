// The board itself: a question typed, and its answers as they come and go; below them every relation.

import { AnswerTable, mostRows } from './answer_table.js';
import { eachFrame, element, failureText, find } from './dom.js';
import { RelationQuestions } from './relation_questions.js';
import { showRelations } from './relations.js';

/** @import { Activity } from './activity.js' */
/** @import { Connection } from './connection.js' */
/** @import { Answer } from './messages' */

// Follows one question at a time: answers what ends the one before and asks the next.
/** @param {Connection} connection @param {AnswerTable} table @param {HTMLElement} count @param {HTMLElement} wrong */
function follower(connection, table, count, wrong) {
  let end = () => {};
  /** @param {string} question */
  return (question) => {
    end();
    wrong.hidden = true;
    count.textContent = '';
    table.begin();
    /** @type {Answer[]} */
    let latest = [];
    let cut = 0;
    const draw = eachFrame(() => {
      const all = latest.length + cut;
      count.textContent = `${all} answer${all === 1 ? '' : 's'}${all > mostRows ? `, ${mostRows} shown` : ''}`;
      table.show(latest);
    });
    end = connection.watch(
      question,
      (answers, message) => {
        latest = answers;
        cut = message.resynchronised ? message.cut : cut + message.cut;
        draw();
      },
      (failure) => {
        wrong.hidden = false;
        wrong.textContent = failureText(failure);
      },
    );
  };
}

/** @param {Connection} connection @param {Activity} activity @param {() => string} me */
export function showFacts(connection, activity, me) {
  const questions = new RelationQuestions(connection);
  const table = new AnswerTable(connection);
  const field = { id: 'query', spellcheck: 'false', list: questions.list.id, placeholder: '(on ?x ?y)', 'aria-label': 'Question' };
  const input = element('input', field);
  const count = element('span', { class: 'quiet', id: 'query-count' });
  const wrong = element('pre', { class: 'answer bad', id: 'query-wrong', hidden: true });
  const submit = element('button', { type: 'submit', class: 'strong' }, 'Watch');
  const form = element('form', { class: 'row' }, input, questions.list, submit, count);
  const ask = follower(connection, table, count, wrong);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    ask(input.value);
  });
  const relations = showRelations(
    activity,
    (name) => questions.of(name) !== undefined,
    (name) => {
      input.value = questions.of(name) ?? '';
      form.requestSubmit();
    },
    me,
  );
  find('facts').append(form, wrong, table.because, table.panel, relations);
}
