// The image streams: the left one plain, and with what the eyes make of it. A stream is chosen by its kind. A click into
// the plain one says where and in which frame, to who asked first for such points and takes this one. Of a moment that has
// gone by they show what was kept.

import { clipped, find } from './dom.js';
import { drawFrame, drawKept, makeImageView, pointIn } from './image_view.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Roles } from './roles.js' */
/** @import { ImageView } from './image_view.js' */
/** @import { Form, PointInImage } from './messages' */

// Why none come.
/** @type {Record<string, string>} */
const closed = { closed: 'the camera is closed: Connect, in Eyes, opens it', opening: 'the camera opens', lost: 'the camera is lost' };

const wanted = [
  { kinds: ['colour', 'left'], title: 'Camera' },
  { kinds: ['annotated'], title: 'What the eyes follow' },
];

// What is shown stays while no images come, and the note says why.
/** @param {Connection} connection @param {Roles} roles @param {(why: string | undefined, trouble: string) => void} told */
function followCamera(connection, roles, told) {
  connection.followAlways('(camera-state ?eyes ?state ?trouble)', (answers) => {
    const cameras = answers.map(fact);
    const [, , state, trouble] = cameras.find((one) => text(one[1]) === roles.server('eyes')) ?? cameras[0] ?? [];
    told(state === undefined ? 'no eyes are present' : closed[text(state)], text(trouble ?? ''));
  });
}

// Follows which stream there is of each kind: `choose` is told the names of all that are wanted, '' where there is none.
/** @param {Connection} connection @param {Roles} roles @param {(names: string[]) => void} choose */
function followStreams(connection, roles, choose) {
  /** @type {Form[]} */
  let streams = [];
  // Streams are named after the eyes that have them. Where those that play the role have none, others' are shown.
  /** @param {string} kind */
  const nameOf = (kind) => {
    const names = streams.filter((stream) => text(stream[2]) === kind).map((stream) => text(stream[1]));
    return names.find((name) => name === `${roles.server('eyes')}-${kind}`) ?? names[0];
  };
  const tell = () => choose(wanted.map(({ kinds }) => kinds.map(nameOf).find(Boolean) ?? ''));
  connection.followAlways('(stream ?name ?kind ?place)', (answers) => {
    streams = answers.map(fact);
    tell();
  });
  roles.onChange(tell);
}

// Where a click goes: to who asked first for such points and takes this one.
/** @param {ImageView} view */
function clicksInto(view) {
  /** @type {((point: PointInImage) => boolean)[]} */
  const takers = [];
  view.canvas.classList.add('clickable');
  view.canvas.addEventListener('click', (event) => {
    const point = pointIn(view, event);
    if (point) takers.some((take) => take(point));
  });
  return takers;
}

/** @typedef {ReturnType<typeof showImages>} Images */
/** @param {Connection} connection @param {Roles} roles */
export function showImages(connection, roles) {
  const views = wanted.map((want) => makeImageView(want.title));
  find('images').append(...views.map((view) => view.card));
  /** @type {number | null} */
  let moment = null;
  /** @param {ImageView} view @param {string} name */
  const look = (view, name) => {
    if (name === view.stream) return;
    view.end();
    view.stream = name;
    view.canvas.dataset.stream = name;
    view.end = name ? connection.look(name, (picture) => moment === null && drawFrame(view, picture)) : () => {};
    if (!name) view.note.textContent = 'no such stream';
  };
  followStreams(connection, roles, (names) => views.forEach((view, i) => look(view, names[i])));
  followCamera(connection, roles, (why, trouble) => {
    if (moment !== null) return;
    const said = clipped([why, trouble].filter(Boolean).join(': '), 120);
    for (const view of views) if (why || !view.shown) view.note.textContent = why ? said : 'no image yet';
  });
  const takers = clicksInto(views[0]);
  return {
    /** @param {(point: PointInImage) => boolean} take */
    onPoint: (take) => takers.push(take),
    /** @param {number | null} then */
    showMoment: (then) => {
      moment = then;
      const isShown = () => moment === then;
      for (const view of views) if (then !== null && view.stream) drawKept(connection, view, then, isShown);
    },
    // The stream that tells most of a moment.
    telling: () => views[1].stream || views[0].stream,
  };
}
