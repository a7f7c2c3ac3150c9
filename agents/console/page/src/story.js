// The story as a timeline, newest first: what was wanted, planned, done, seen otherwise. An entry opens its detail and
// what it was told because of; above them the coordinator says why it does what it does.

import { clipped, clock, eachFrame, element, failureText, find } from './dom.js';
import { fact } from './live_answers.js';
import { text, write } from './datum.js';

const shown = 200;

function entryOf(answer, isOpen) {
  const [, number, kind, sentence, detail] = fact(answer);
  const { teller, when, because } = answer.facts[0];
  const summary = element(
    'summary',
    {},
    element('time', {}, clock(when)),
    element('span', { class: `kind ${text(kind)}` }, text(kind)),
    element('span', {}, clipped(text(sentence))),
  );
  const said = [`fact ${answer.ids[0]}, told by ${teller}`];
  if (because.length) said.push(`because of fact${because.length > 1 ? 's' : ''} ${because.join(', ')}`);
  return element(
    'details',
    { open: isOpen, 'data-number': number },
    summary,
    element('p', { class: 'quiet' }, said.join(', ')),
    element('pre', {}, clipped(write(detail), 4000)),
  );
}

export function showStory(connection) {
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
  find('story').append(
    element('div', { class: 'row' }, element('button', { type: 'button', id: 'why', onclick: ask }, 'Why this, now?')),
    why,
    list,
  );

  let answers = [];
  const entries = new Map();
  const draw = eachFrame(() => {
    const newest = answers.toSorted((a, b) => fact(b)[1] - fact(a)[1]).slice(0, shown);
    const ids = new Set(newest.map((answer) => answer.ids[0]));
    for (const id of entries.keys()) if (!ids.has(id)) entries.delete(id);
    for (const answer of newest) if (!entries.has(answer.ids[0])) entries.set(answer.ids[0], entryOf(answer, false));
    list.replaceChildren(...newest.map((answer) => entries.get(answer.ids[0])));
  });
  connection.follow('(event ?n ?kind ?sentence ?detail)', (held) => {
    answers = held;
    draw();
  });
}
