// STOP: a stop fact, told by the button or by Escape from anywhere. It stands until somebody clears it.

import { confirmed } from './confirm.js';
import { clipped, failureText, find } from './dom.js';
import { fact } from './live_answers.js';
import { nameOf } from './names.js';
import { Reasons } from './reasons.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Hands } from './hands.js' */
/** @import { Permission } from './permission.js' */

const longestStop = 1000; // milliseconds, until it is acknowledged
const byKey = 'Escape, from anywhere';
const otherwise = 'use the button at the cell';

/** @param {string} sentence '' where there is nothing to fear */
function warn(sentence) {
  find('stop-alarm').textContent = sentence;
  find('stop-alarm').hidden = sentence === '';
}
/** @param {string} sentence */
const say = (sentence) => (find('stop-note').textContent = sentence);

// Who presses it hears within a second that it was told, or that it may not have been.
/** @param {Connection} connection */
async function stop(connection) {
  const late = setTimeout(() => warn(`STOP is not confirmed: ${otherwise}`), longestStop);
  /** @param {any} failure */
  const unconfirmed = (failure) => {
    clearTimeout(late);
    warn(`STOP is not confirmed: ${otherwise} (${failureText(failure)})`);
  };
  try {
    await connection.stop("the operator's STOP", unconfirmed);
    say('STOP is told');
    warn('');
  } catch (failure) {
    unconfirmed(failure);
  }
  clearTimeout(late);
}

/** @param {Connection} connection */
function stopWhenPressed(connection) {
  find('stop').addEventListener('click', () => stop(connection));
  // While a dialog asks, nothing beside it can be pressed.
  find('confirm-stop').addEventListener('click', () => {
    stop(connection);
    find('confirm').close();
  });
  /** @param {KeyboardEvent} event */
  const escape = (event) => {
    if (event.key === 'Escape' && !event.repeat) stop(connection);
  };
  window.addEventListener('keydown', escape, { capture: true });
}

/** @param {Connection} connection */
async function clearStops(connection) {
  if (!(await confirmed('Is everybody out of the way? Clearing the stop lets the arm move again.'))) return;
  try {
    await connection.clearStops();
  } catch (failure) {
    say(failureText(failure));
  }
}

/** @param {Connection} connection @param {Permission} permission @param {Hands} hands */
export function showStop(connection, permission, hands) {
  stopWhenPressed(connection);
  const clear = find('clear-stops');
  clear.addEventListener('click', () => clearStops(connection));
  const off = new Reasons('why-not-cleared');
  clear.after(off.note);
  const unable = new Reasons('why-no-stop');
  find('stop-note').after(unable.note);
  hands.onChange(() => {
    const why = permission.right('clear-stops') || hands.why;
    off.set('Clear', [clear], why && `${why}. Who clears a stop sets the arm free`);
    const never = permission.right('stop');
    unable.set('STOP', [find('stop'), find('confirm-stop')], never && `${never}: ${otherwise}`);
  });
  connection.followAlways('(stop ?who ?reason)', (answers) => {
    find('stopped').hidden = answers.length === 0;
    if (answers.length > 0) warn('');
    else say(byKey);
    const said = answers.map((answer) => `${nameOf(text(fact(answer)[1]), hands.me)}: ${text(fact(answer)[2])}`);
    find('stopped-by').textContent = clipped(said.join('; '));
  });
}
