// One stream's image on the page: the newest frame, or what was kept of a moment that has gone by; and which pixel of which
// frame is clicked.

import { clock, element, failureText, penOn } from './dom.js';

/** @import { Connection } from './connection.js' */
/** @import { Picture, PointInImage } from './messages' */

/** `shown`: which frame it is, and how large.
 * @typedef {{
 *   canvas: HTMLCanvasElement, note: HTMLElement, card: HTMLElement, stream: string,
 *   shown: { number: number, width: number, height: number } | null, end: () => void }} ImageView */

/** @param {string} title @returns {ImageView} */
export function makeImageView(title) {
  const canvas = element('canvas', { width: 640, height: 480, role: 'img', 'aria-label': title });
  const note = element('span', { class: 'quiet' }, 'no eyes are present');
  const card = element(
    'figure',
    { class: 'card' },
    canvas,
    element('figcaption', {}, element('span', {}, title), note),
  );
  return { canvas, note, card, stream: '', shown: null, end: () => {} };
}

/** @param {HTMLCanvasElement} canvas @param {Picture} picture */
export function drawPicture(canvas, picture) {
  if (canvas.width !== picture.width || canvas.height !== picture.height) {
    canvas.width = picture.width;
    canvas.height = picture.height;
  }
  penOn(canvas).drawImage(picture.bitmap, 0, 0, picture.width, picture.height);
}

/** @param {ImageView} view @param {Picture} picture */
export function drawFrame(view, picture) {
  const { canvas } = view;
  drawPicture(canvas, picture);
  view.shown = { number: picture.number, width: picture.width, height: picture.height };
  view.note.textContent = `frame ${picture.number}`;
  // For who measures.
  canvas.dataset.captured = String(picture.captured);
  canvas.dataset.frame = String(picture.number);
}

// A click into what has gone by is none.
/** @param {Connection} connection @param {ImageView} view @param {number} moment @param {() => boolean} isShown */
export async function drawKept(connection, view, moment, isShown) {
  view.shown = null;
  view.note.textContent = 'looking for what was kept …';
  try {
    const kept = await connection.picture(view.stream, moment);
    if (isShown()) {
      drawPicture(view.canvas, kept);
      view.note.textContent = `frame ${kept.number}, ${clock(kept.captured)}`;
    }
    kept.bitmap.close();
  } catch (failure) {
    if (!isShown()) return;
    penOn(view.canvas).clearRect(0, 0, view.canvas.width, view.canvas.height);
    view.note.textContent = failureText(failure);
  }
}

// Of the image that is shown, though it is drawn with room around it.
/** @param {ImageView} view @param {MouseEvent} event @returns {PointInImage | null} */
export function pointIn(view, event) {
  if (!view.shown) return null;
  const { width, height, number } = view.shown;
  const box = view.canvas.getBoundingClientRect();
  const scale = Math.min(box.width / width, box.height / height);
  const x = Math.round((event.clientX - box.left - (box.width - scale * width) / 2) / scale);
  const y = Math.round((event.clientY - box.top - (box.height - scale * height) / 2) / scale);
  return x >= 0 && y >= 0 && x < width && y < height ? { x, y, frame: number } : null;
}
