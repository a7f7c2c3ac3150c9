// The board itself: a question typed, and its answers as they come and go; below them every relation.

import { clipped, eachFrame, element, failureText, find } from './dom.js';
import { fact } from './live_answers.js';
import { provenance, toldBy } from './provenance.js';
import { showRelations } from './relations.js';
import { text } from './datum.js';

/** @import { Activity } from './activity.js' */
/** @import { Connection } from './connection.js' */
/** @import { Answer, Form } from './messages' */

const shown = 200;

// `(relation on ((a symbol) (b symbol)) ...)` as the question for all of it
/** @param {Form} relation */
const questionFor = (relation) =>
  `(${text(relation[1])}${relation[2].map((/** @type {Form} */ argument) => ` ?${text(argument[0])}`).join('')})`;

/** @param {Answer[]} answers @param {(answer: Answer) => boolean} isNew */
function table(answers, isNew) {
  if (answers.length === 0) return element('p', { class: 'quiet' }, 'nothing, now');
  const variables = Object.keys(answers[0].bindings);
  const head = element('tr', {}, ...(variables.length ? variables : ['fact']).map((name) => element('th', {}, name)), element('td', {}));
  const rows = answers.slice(0, shown).map((answer) => {
    const told = answer.facts.map((one, i) => toldBy(answer.ids[i], one));
    const cells = variables.length
      ? variables.map((name) => answer.bindings[name] ?? '')
      : [answer.facts[0]?.text ?? 'yes'];
    return element(
      'tr',
      { title: told.join('\n'), class: isNew(answer) ? 'new' : '' },
      ...cells.map((cell) => element('td', {}, clipped(cell, 160))),
      element('td', {}, element('button', { type: 'button', class: 'because', 'data-ids': answer.ids.join() }, 'Because …')),
    );
  });
  return element('table', {}, element('thead', {}, head), element('tbody', {}, ...rows));
}

/** @param {Connection} connection @param {Activity} activity */
export function showFacts(connection, activity) {
  const input = element('input', {
    id: 'query',
    spellcheck: 'false',
    list: 'questions',
    placeholder: '(on ?x ?y)',
    'aria-label': 'Question',
  });
  const known = element('datalist', { id: 'questions' });
  const count = element('span', { class: 'quiet', id: 'query-count' });
  const wrong = element('pre', { class: 'answer bad', id: 'query-wrong', hidden: true });
  const result = element('div', { class: 'scroll', id: 'answers' });
  const form = element(
    'form',
    { class: 'row' },
    input,
    known,
    element('button', { type: 'submit', class: 'strong' }, 'Watch'),
    count,
  );
  const because = element('div', { id: 'because', role: 'group', 'aria-label': 'Reasons', tabindex: 0, hidden: true });
  /** @type {Map<string, string>} */
  const questions = new Map(); // for all of a relation
  const relations = showRelations(
    activity,
    (name) => questions.has(name),
    (name) => {
      input.value = questions.get(name) ?? '';
      form.requestSubmit();
    },
  );
  find('facts').append(form, wrong, because, result, relations);

  // The rows are drawn anew whenever something changes: what is pressed counts, not what is let go.
  /** @type {Answer[]} */
  let shownAnswers = [];
  /** @param {Event} event */
  const explain = async (event) => {
    const pressed = event.target instanceof Element ? event.target.closest('button.because') : null;
    const ids = pressed?.getAttribute('data-ids');
    const answer = shownAnswers.find((one) => one.ids.join() === ids);
    if (!answer) return;
    const trees = answer.facts.map((one, i) => provenance(connection, answer.ids[i], one));
    because.replaceChildren(...(await Promise.all(trees)));
    because.hidden = false;
  };
  result.addEventListener('pointerdown', explain);
  result.addEventListener('keydown', (event) => ['Enter', ' '].includes(event.key) && explain(event));

  let end = () => {};
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    end();
    wrong.hidden = true;
    count.textContent = '';
    result.replaceChildren();
    because.hidden = true;
    /** @type {Answer[]} */
    let latest = [];
    let cut = 0;
    let seen = new Set();
    const draw = eachFrame(() => {
      const more = latest.length + cut > shown ? `, ${shown} shown` : '';
      count.textContent = `${latest.length + cut} answer${latest.length + cut === 1 ? '' : 's'}${more}`;
      shownAnswers = latest;
      const before = seen;
      seen = new Set(latest.slice(0, shown).map((answer) => answer.ids.join()));
      result.replaceChildren(table(latest, (answer) => before.size > 0 && !before.has(answer.ids.join())));
    });
    end = connection.watch(
      input.value,
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
  });

  connection.follow('(contract ?name ?form)', (answers) => {
    const posts = answers
      .flatMap((answer) => fact(answer)[2])
      .filter((part) => Array.isArray(part) && text(part[0]) === 'posts');
    const told = posts.flatMap((part) => part.slice(1)).filter((relation) => Array.isArray(relation?.[2]));
    questions.clear();
    for (const relation of told) questions.set(text(relation[1]), questionFor(relation));
    known.replaceChildren(...[...questions.values()].sort().map((question) => element('option', { value: question })));
  });
}
