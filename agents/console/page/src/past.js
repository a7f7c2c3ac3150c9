// A slider back into the journal: what was known then, in the same views, while the cell goes on. Its board must keep a
// journal. STOP, and whatever is sent, is of now.

import { clock, element, failureText, find } from './dom.js';

/** @import { Connection } from './connection.js' */
/** @import { Images } from './images.js' */
/** @import { Permission } from './permission.js' */
/** @import { Answer } from './messages' */

// Answers what goes to a moment that is named.
/** @param {Connection} connection @param {Permission} permission @param {Images} images */
export function showPast(connection, permission, images) {
  const bar = find('past');
  const slider = element('input', {
    type: 'range',
    id: 'moment',
    min: 0,
    max: 1000,
    value: 1000,
    disabled: true,
    'aria-label': 'Back in time',
  });
  const note = element('output', { id: 'moment-note', for: 'moment' }, 'now');
  const now = element('button', { type: 'button', id: 'back-to-now', disabled: true }, 'Now');
  bar.append(element('label', { for: 'moment' }, 'Time'), slider, note, now);

  let first = 0;
  const at = () => Math.round(first + ((Date.now() * 1000 - first) * Number(slider.value)) / 1000);
  /** @param {number | null} moment */
  const show = async (moment) => {
    document.body.classList.toggle('past', moment !== null);
    permission.set({ past: moment !== null });
    now.disabled = moment === null;
    note.textContent = moment === null ? 'now' : `${clock(moment)} …`;
    images.showMoment(moment);
    const failure = await connection.showMoment(moment);
    // Another moment may have been chosen meanwhile.
    if (moment === null || connection.moment !== moment) return;
    note.textContent = failure ? failureText(failure) : `as it was at ${clock(moment)}`;
  };
  slider.addEventListener('input', () => (note.textContent = clock(at())));
  slider.addEventListener('change', () => show(Number(slider.value) === 1000 ? null : at()));
  now.addEventListener('click', () => {
    slider.value = '1000';
    show(null);
  });
  // As far back as anything that is known was told.
  /** @param {Answer[]} answers */
  const since = (answers) => {
    for (const { facts } of answers) first = first ? Math.min(first, facts[0].when) : facts[0].when;
    slider.disabled = first === 0;
  };
  connection.followAlways('(agent ?name ?kind ?host)', since);
  connection.followAlways('(event ?n ?kind ?sentence ?detail)', since);
  /** @param {number} moment */
  return (moment) => {
    slider.value = String(((moment - first) * 1000) / (Date.now() * 1000 - first));
    show(moment);
  };
}
