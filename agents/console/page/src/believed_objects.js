// The objects in the scene: each stands where the coordinator places it, as sure and as exact as the eyes say. The arm's
// target is marked.
//
//   const objects = new BelievedObjects(connection, view);
//   objects.setCell(hello); objects.believe(seen, camera.frame); objects.mark('circle');
//   objects.step()        moves them on; whether any still moves

import { Group } from 'three';
import { fact } from './live_answers.js';
import { ObjectFigure } from './object_figure.js';
import { text } from './datum.js';

/** @import { Frame } from './camera_frame.js' */
/** @import { View } from './cell_view.js' */
/** @import { Connection } from './connection.js' */
/** @import { Sighting } from './sightings.js' */
/** @import { Answer, Form, Hello } from './messages' */

const most = 64;

export class BelievedObjects {
  #view;
  #cube = 60; // mm
  #target = '';
  /** @type {Map<string, Sighting>} */
  #seen = new Map();
  /** @type {Frame | null} */
  #frame = null;
  /** @type {Map<string, ObjectFigure>} */
  #figures = new Map();
  group = new Group();

  /** @param {Connection} connection @param {View} view */
  constructor(connection, view) {
    this.#view = view;
    connection.follow('(place ?name ?x ?y ?z ?frame)', (answers) => this.#place(answers));
  }

  /** @param {Pick<Hello, 'cube'>} cell */
  setCell({ cube }) {
    this.#cube = cube;
  }
  // What the eyes say of each, in the frame of the camera.
  /** @param {Map<string, Sighting>} seen @param {Frame | null} frame */
  believe(seen, frame) {
    this.#seen = seen;
    this.#frame = frame;
    for (const [name, figure] of this.#figures) figure.believe(seen.get(name), frame);
    this.#view.says('spread', [...this.#figures.values()].filter((figure) => figure.hasSpread()).length);
  }
  /** @param {string} target */
  mark(target) {
    this.#target = target;
    for (const [name, figure] of this.#figures) figure.mark(name === target);
    this.#view.says('target', this.#figures.has(target) ? target : '');
    this.#view.ask();
  }
  step() {
    return [...this.#figures.values()].map((figure) => figure.step()).includes(true);
  }
  topOfTarget() {
    return this.#figures.get(this.#target)?.top();
  }

  /** @param {Answer[]} answers */
  #place(answers) {
    const placed = new Map(answers.map((answer) => [text(fact(answer)[1]), fact(answer)]));
    for (const [name, figure] of this.#figures) {
      if (placed.has(name)) continue;
      this.group.remove(figure.group);
      this.#figures.delete(name);
    }
    for (const [name, told] of placed) this.#move(name, told);
    this.believe(this.#seen, this.#frame);
    this.mark(this.#target);
  }
  /** @param {string} name @param {Form} placed */
  #move(name, [, , x, y, z]) {
    let figure = this.#figures.get(name);
    if (!figure) {
      if (this.#figures.size >= most) return;
      figure = new ObjectFigure(name, this.#cube);
      this.#figures.set(name, figure);
      this.group.add(figure.group);
    }
    figure.goTo(x, y, z);
  }
}
