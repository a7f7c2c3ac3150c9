// Why a control of the eyes is off: who holds a mode that excludes what it does.
//
//   const why = whyEyesOff(held, me);       why.train is '' where a mark may be learned

import { nameOf } from './names.js';

/** A client, and the mode that it holds.
 * @typedef {[client: string, mode: string]} Held */

/** @typedef {ReturnType<typeof whyEyesOff>} WhyOff */
/** @param {Held[]} held @param {string} me */
export function whyEyesOff(held, me) {
  /** @param {string} mode */
  const by = (mode) => held.filter(([, holds]) => holds === mode).map(([client]) => client);
  /** @param {string} client */
  const named = (client) => nameOf(client, me);
  const trackers = by('tracking');
  const learners = by('learning');
  const tracks = trackers.length ? `${trackers.map(named).join(', ')} ${trackers.includes(me) ? 'track' : 'tracks'}, which excludes learning: end that first` : '';
  const learns = learners.length ? `${named(learners[0])} ${learners[0] === me ? 'are' : 'is'} learning` : '';
  const connected = by('connected').includes(me);
  return {
    connect: connected ? 'you are connected' : '',
    disconnect: connected ? '' : 'you are not connected',
    find: '',
    train: tracks || (learners.includes(me) ? '' : learns),
    forget: tracks || learns,
    track: learns,
    end: trackers.includes(me) ? '' : trackers.length ? `${named(trackers[0])} tracks, and ends it itself` : 'nothing is tracked',
  };
}

// All of it is off for the same reason.
/** @param {string} why @returns {WhyOff} */
export const allOff = (why) => ({ connect: why, disconnect: why, find: why, train: why, forget: why, track: why, end: why });
