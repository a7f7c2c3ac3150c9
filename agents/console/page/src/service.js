// The robot's service: whether its agent is there, and moves the arm or has given it back to the people beside it.

import { element } from './dom.js';
import { fact } from './live_answers.js';
import { nameOf } from './names.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Hands } from './hands.js' */

// `why` says why nothing moves now, '' where something may.
/** @param {Connection} connection @param {Hands} hands @param {() => void} changed */
export function showService(connection, hands, changed) {
  const light = element('span', { id: 'service-light', class: 'chip', role: 'status' });
  /** @type {Set<string>} */
  let present = new Set();
  /** @type {Map<string, string>} */
  let released = new Map();
  const why = () => {
    if (!present.has(hands.robot)) return 'No robot is present';
    return released.has(hands.robot) ? `${nameOf(released.get(hands.robot) ?? '', hands.me)} released control: get it first` : '';
  };
  const show = () => {
    light.textContent = why() || 'In service';
    light.className = `chip ${why() ? 'bad' : 'good'}`;
    changed();
  };
  connection.followAlways('(agent ?name robot ?host)', (answers) => {
    present = new Set(answers.map((answer) => text(fact(answer)[1])));
    show();
  });
  connection.followAlways('(robot-released ?robot ?client)', (answers) => {
    released = new Map(answers.map((answer) => [text(fact(answer)[1]), text(fact(answer)[2])]));
    show();
  });
  hands.onChange(show);
  return { light, why };
}
