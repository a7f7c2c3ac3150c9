// The camera's view: from where the coordinator believes it, or the cell file has it, turned by the head that it stands
// on, as wide as its model says. Nobody knows the view of a head that does not say how it is turned, and none is drawn.

import { BufferGeometry, LineBasicMaterial, LineSegments } from 'three';
import { cameraFrame } from './camera_frame.js';
import { fact } from './live_answers.js';

/** @import { Frame, Turn } from './camera_frame.js' */
/** @import { View } from './cell_view.js' */
/** @import { Connection } from './connection.js' */
/** @import { Camera, Form, Hello } from './messages' */

const far = 320;

/** @param {Frame} frame @param {Form} model */
function frustum({ eye, right, down, ahead }, model) {
  const [, , width, height, focal] = model;
  /** @param {number} x @param {number} y */
  const corner = (x, y) =>
    eye
      .clone()
      .addScaledVector(ahead, far)
      .addScaledVector(right, (x * far * width) / 2 / focal)
      .addScaledVector(down, (y * far * height) / 2 / focal);
  const corners = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
  const points = corners.flatMap((c, i) => [eye, c, c, corners[(i + 1) % 4]]);
  return new LineSegments(
    new BufferGeometry().setFromPoints(points),
    new LineBasicMaterial({ color: 0x4fb3ff, transparent: true, opacity: 0.6 }),
  );
}

const unturned = { pan: 0, tilt: 0 };

export class CameraFigure {
  #view;
  #moved;
  /** @type {Camera | null} */
  #ofFile = null;
  /** @type {Omit<Camera, 'head'> | null} */
  #believed = null;
  /** @type {Form | null} */
  #model = null;
  /** @type {Turn | null} */
  #turn = null;
  /** @type {LineSegments | null} */
  #figure = null;
  /** @type {Frame | null} */
  frame = null; // where it is known

  // `moved` is told whenever the frame has changed.
  /** @param {Connection} connection @param {View} view @param {() => void} moved */
  constructor(connection, view, moved) {
    this.#view = view;
    this.#moved = moved;
    /** @param {string} query @param {(told: Form | null) => void} take */
    const follow = (query, take) =>
      connection.follow(query, (answers) => {
        take(answers.length ? fact(answers[0]) : null);
        this.#show();
      });
    follow('(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)', (model) => (this.#model = model));
    follow('(head ?pan ?tilt ?state)', (head) => (this.#turn = head && { pan: head[1], tilt: head[2] }));
    follow('(camera-pose ?x ?y ?z ?pan ?tilt ?roll ?state ?spread ?guess)', (told) => {
      this.#believed = told && { at: [told[1], told[2], told[3]], pan: told[4], tilt: told[5], roll: told[6] };
    });
  }

  /** @param {Hello} cell */
  setCell({ camera }) {
    this.#ofFile = camera;
    this.#show();
  }

  #show() {
    if (this.#figure) this.#view.scene.remove(this.#figure);
    const camera = this.#ofFile && { ...this.#ofFile, ...this.#believed };
    const turn = camera?.head ? this.#turn : unturned;
    this.frame = camera && turn ? cameraFrame(camera, turn) : null;
    this.#figure = this.frame && this.#model && this.#model[4] > 0 ? frustum(this.frame, this.#model) : null;
    if (this.#figure) this.#view.scene.add(this.#figure);
    this.#view.says('camera', Boolean(this.#figure));
    this.#moved();
    this.#view.ask();
  }
}
