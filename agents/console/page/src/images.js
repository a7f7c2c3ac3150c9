// The image streams: the left one plain, and with what the eyes make of it. A stream is chosen by its kind. A click into
// the plain one says where and in which frame, to who asked first for such points and takes this one. Of a moment that has
// gone by they show what was kept.

import { clipped, clock, element, failureText, find, penOn } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Roles } from './roles.js' */
/** @import { Form, Picture, PointInImage } from './messages' */

// Why none come.
/** @type {Record<string, string>} */
const closed = { closed: 'the camera is closed: Connect, in Eyes, opens it', opening: 'the camera opens', lost: 'the camera is lost' };

const wanted = [
  { kinds: ['colour', 'left'], title: 'Camera' },
  { kinds: ['annotated'], title: 'What the eyes follow' },
];

/** One stream's image; `shown`: which frame of it, and how large.
 * @typedef {{
 *   canvas: HTMLCanvasElement, note: HTMLElement, card: HTMLElement, stream: string,
 *   shown: { number: number, width: number, height: number } | null, end: () => void }} ImageView */

/** @param {string} title @returns {ImageView} */
function makeView(title) {
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
function draw(view, picture) {
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
async function drawKept(connection, view, moment, isShown) {
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
function pointIn(view, event) {
  if (!view.shown) return null;
  const { width, height, number } = view.shown;
  const box = view.canvas.getBoundingClientRect();
  const scale = Math.min(box.width / width, box.height / height);
  const x = Math.round((event.clientX - box.left - (box.width - scale * width) / 2) / scale);
  const y = Math.round((event.clientY - box.top - (box.height - scale * height) / 2) / scale);
  return x >= 0 && y >= 0 && x < width && y < height ? { x, y, frame: number } : null;
}

/** @typedef {ReturnType<typeof showImages>} Images */
/** @param {Connection} connection @param {Roles} roles */
export function showImages(connection, roles) {
  const views = wanted.map((want) => makeView(want.title));
  find('images').append(...views.map((view) => view.card));
  /** @type {number | null} */
  let moment = null;
  /** @type {Form[]} */
  let streams = [];
  // Streams are named after the eyes that have them. Where those that play the role have none, others' are shown.
  /** @param {string} kind */
  const nameOf = (kind) => {
    const names = streams.filter((stream) => text(stream[2]) === kind).map((stream) => text(stream[1]));
    return names.find((name) => name === `${roles.server('eyes')}-${kind}`) ?? names[0];
  };
  const choose = () =>
    wanted.forEach((want, index) => {
      const view = views[index];
      const name = want.kinds.map(nameOf).find(Boolean) ?? '';
      if (name === view.stream) return;
      view.end();
      view.stream = name;
      view.canvas.dataset.stream = name;
      view.end = name ? connection.look(name, (picture) => moment === null && draw(view, picture)) : () => {};
      if (!name) view.note.textContent = 'no such stream';
    });
  connection.followAlways('(stream ?name ?kind ?place)', (answers) => {
    streams = answers.map(fact);
    choose();
  });
  roles.onChange(choose);
  // What is shown stays while no images come, and the note says why.
  connection.followAlways('(camera-state ?eyes ?state ?trouble)', (answers) => {
    const told = answers.map(fact);
    const [, , state, trouble] = told.find((one) => text(one[1]) === roles.server('eyes')) ?? told[0] ?? [];
    const why = state === undefined ? 'no eyes are present' : closed[text(state)];
    if (moment !== null) return;
    const said = clipped([why, text(trouble ?? '')].filter(Boolean).join(': '), 120);
    for (const view of views) if (why || !view.shown) view.note.textContent = why ? said : 'no image yet';
  });
  /** @type {((point: PointInImage) => boolean)[]} */
  const takers = [];
  const [plain] = views;
  plain.canvas.classList.add('clickable');
  plain.canvas.addEventListener('click', (event) => {
    const point = pointIn(plain, event);
    if (point) takers.some((take) => take(point));
  });
  /** @param {number | null} then */
  const showMoment = (then) => {
    moment = then;
    const isShown = () => moment === then;
    for (const view of views) if (then !== null && view.stream) drawKept(connection, view, then, isShown);
  };
  // The stream that tells most of a moment.
  const telling = () => views[1].stream || views[0].stream;
  /** @param {(point: PointInImage) => boolean} take */
  const onPoint = (take) => takers.push(take);
  return { onPoint, showMoment, telling };
}
