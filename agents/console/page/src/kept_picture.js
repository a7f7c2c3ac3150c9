// What the eyes made of what they saw at a moment, from what the console keeps; or why there is no picture.

import { clock, element, failureText } from './dom.js';
import { drawPicture } from './image_view.js';

/** @import { Connection } from './connection.js' */

/** @param {Connection} connection @param {string} stream @param {number} moment */
export function keptPicture(connection, stream, moment) {
  const canvas = element('canvas', { role: 'img', 'aria-label': `What was seen at ${clock(moment)}`, hidden: true });
  const note = element('figcaption', { class: 'quiet' }, 'looking for the picture …');
  const load = async () => {
    if (!stream) return (note.textContent = 'no stream of images is told');
    try {
      const kept = await connection.picture(stream, moment);
      drawPicture(canvas, kept);
      kept.bitmap.close();
      canvas.hidden = false;
      note.textContent = `frame ${kept.number}, ${clock(kept.captured)}`;
    } catch (failure) {
      note.textContent = failureText(failure);
    }
  };
  load();
  return element('figure', { class: 'kept' }, canvas, note);
}
