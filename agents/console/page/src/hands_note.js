// What an operator is told of the arm's hands, whatever is on the screen: who asks for the arm, and that it was taken
// over or was lost, both who took it and who lost it.

import { element, failureText, find } from './dom.js';
import { you } from './names.js';

/** @import { Hands } from './hands.js' */

/** @param {Hands} hands */
export function showHandsNote(hands) {
  const bar = find('hands-note');
  const said = element('span', {});
  const act = element('button', { type: 'button' });
  bar.append(said, act);
  let doing = () => {};
  act.addEventListener('click', () => doing());

  /** @param {string} sentence @param {string} label @param {() => void} does */
  const show = (sentence, label, does) => {
    bar.hidden = sentence === '';
    if (said.textContent !== sentence) said.textContent = sentence;
    act.textContent = label;
    doing = does;
  };
  const letGo = () => hands.toggle().catch((failure) => (said.textContent = failureText(failure)));
  const read = () => {
    hands.change = null;
    draw();
  };
  const draw = () => {
    const { change, mine } = hands;
    const [asker] = hands.askers;
    if (change && !change.to) return show('You no longer have the arm in hand.', 'OK', read);
    if (change && change.to !== you) return show(`${change.to} has taken the arm over.`, 'OK', read);
    if (mine && asker) return show(`${asker} asks for the arm.`, `Let ${asker} have it`, letGo);
    if (change && mine) return show(`You have taken the arm over from ${change.from}, who is told.`, 'OK', read);
    return show('', '', () => {});
  };
  hands.onChange(draw);
}
