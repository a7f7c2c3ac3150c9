// Who is there, and what each offers; who serves whom; and whom the board refused what.

import { clipped, element, find } from './dom.js';
import { fact } from './live_answers.js';
import { showRefusals } from './refusals.js';
import { showServed } from './served.js';
import { text, write } from './datum.js';

export function showAgents(connection) {
  const list = element('div', { class: 'timeline' });
  find('agents').append(list, showRefusals(connection), showServed(connection));
  let present = [];
  const contracts = new Map();
  const draw = () => {
    const rows = present.slice(0, 64).map((agent) => {
      const offers = (contracts.get(text(agent[1])) ?? [])
        .filter((part) => text(part[0]) === 'offers')
        .flatMap((part) => part.slice(1));
      return element(
        'details',
        {},
        element(
          'summary',
          {},
          element('strong', {}, clipped(text(agent[1]), 64)),
          element('span', { class: 'quiet' }, `${text(agent[2])} on ${clipped(text(agent[3]), 64)}`),
        ),
        element('pre', {}, clipped(offers.map(write).join('\n') || 'offers nothing', 4000)),
      );
    });
    list.replaceChildren(...rows);
  };
  connection.follow('(agent ?name ?kind ?host)', (answers) => {
    present = answers.map(fact);
    draw();
  });
  connection.follow('(contract ?name ?form)', (answers) => {
    contracts.clear();
    for (const [, name, form] of answers.map(fact)) contracts.set(text(name), form.filter(Array.isArray));
    draw();
  });
}
