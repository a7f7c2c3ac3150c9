// The board itself: a question typed, and its answers as they come and go.

import { clipped, clock, eachFrame, element, failureText, find } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

const shown = 200;

// `(relation on ((a symbol) (b symbol)) ...)` as the question for all of it
const questionFor = (relation) =>
  `(${text(relation[1])}${relation[2].map((argument) => ` ?${text(argument[0])}`).join('')})`;

function table(answers, isNew) {
  if (answers.length === 0) return element('p', { class: 'quiet' }, 'nothing, now');
  const variables = Object.keys(answers[0].bindings);
  const head = element('tr', {}, ...(variables.length ? variables : ['fact']).map((name) => element('th', {}, name)));
  const rows = answers.slice(0, shown).map((answer) => {
    const told = answer.facts.map(
      (one, i) =>
        `fact ${answer.ids[i]} by ${one.teller} at ${clock(one.when)}` +
        (one.because.length ? `, because of ${one.because.join(', ')}` : ''),
    );
    const cells = variables.length
      ? variables.map((name) => answer.bindings[name] ?? '')
      : [answer.facts[0]?.text ?? 'yes'];
    return element(
      'tr',
      { title: told.join('\n'), class: isNew(answer) ? 'new' : '' },
      ...cells.map((cell) => element('td', {}, clipped(cell, 160))),
    );
  });
  return element('table', {}, element('thead', {}, head), element('tbody', {}, ...rows));
}

export function showFacts(connection) {
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
  find('facts').append(form, wrong, result);

  let end = () => {};
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    end();
    wrong.hidden = true;
    count.textContent = '';
    result.replaceChildren();
    let latest = [];
    let cut = 0;
    let seen = new Set();
    const draw = eachFrame(() => {
      const more = latest.length + cut > shown ? `, ${shown} shown` : '';
      count.textContent = `${latest.length + cut} answer${latest.length + cut === 1 ? '' : 's'}${more}`;
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
    const relations = posts.flatMap((part) => part.slice(1)).filter((relation) => Array.isArray(relation?.[2]));
    const questions = [...new Set(relations.map(questionFor))].sort();
    known.replaceChildren(...questions.map((question) => element('option', { value: question })));
  });
}
