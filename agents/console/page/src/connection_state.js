// Whether there is a live line to the console. Where there is none, what is shown is old and says so, and what commands
// is inert; STOP alone is not.

import { clipped, find } from './dom.js';

/** @import { State } from './connection.js' */
/** @import { Permission } from './permission.js' */

/** @type {Record<State, string>} */
const said = {
  connecting: 'connecting',
  live: 'live',
  silent: 'silent',
  lost: 'no connection',
  refused: 'no session',
  outdated: 'of another version',
};
const commanding = ['want', 'eyes', 'drive', 'head'];

/** @param {Permission} permission */
export function showConnectionState(permission) {
  const chip = find('state');
  /** @param {State} state @param {string} why */
  return (state, why = '') => {
    const live = state === 'live';
    const words = [said[state], clipped(why, 160)].filter(Boolean).join(state === 'silent' ? ' ' : ': ');
    if (chip.textContent !== words) chip.textContent = words;
    chip.className = `chip ${live ? 'good' : 'bad'}`;
    document.body.dataset.state = state;
    if (state !== 'connecting') find('line-note').hidden = live;
    for (const part of commanding) find(part).inert = !live;
    permission.set({ live });
  };
}
