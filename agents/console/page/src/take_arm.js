// To take the arm in hand, let it go, take it over from another, or ask for it; and why that is off.

import { element, failureText } from './dom.js';
import { Reasons } from './reasons.js';

/** @import { Hands } from './hands.js' */
/** @import { Permission } from './permission.js' */

/** @param {Hands} hands @param {Permission} permission */
export function takeArm(hands, permission) {
  const reasons = new Reasons('why-take');
  const note = element('span', { class: 'quiet' });
  /** @param {() => Promise<unknown>} act */
  const noted = (act) => () => act().catch((failure) => (note.textContent = failureText(failure)));
  const take = element('button', { type: 'button', id: 'take-arm', class: 'strong', onclick: noted(() => hands.toggle()) });
  const ask = element('button', { type: 'button', id: 'ask-for-arm', onclick: noted(() => hands.toggleWish()) });
  hands.onChange((mine, holder) => {
    reasons.set('The arm in hand', [take], hands.whyNotTaken);
    const asks = holder !== '' && !mine;
    reasons.set('To ask for it', asks ? [ask] : [], permission.line || permission.right('ask-for'));
    ask.hidden = !asks;
    ask.textContent = hands.asking ? 'Ask no more' : 'Ask for it';
    take.textContent = mine ? 'Let the arm go' : holder ? `Take over from ${hands.holderName}` : 'Take the arm in hand';
    const other = hands.asking ? `${hands.holderName} is asked for it.` : '';
    note.textContent = mine ? 'Only you move the arm now.' : holder ? other : 'Anybody may move the arm: a goal, a prompt.';
  });
  return [element('div', { class: 'row' }, take, ask, note), reasons.note];
}
