// The one arm that the scene shows, of those whose joints the console tells, and how far it reaches.
//
//   const arm = new ChosenArm(view);
//   arm.setCell(hello); arm.choose('robot');
//   arm.move(message);        of any arm
//   arm.step()                moves it on; whether it still moves

import { ArmFigure } from './arm_figure.js';
import { ReachFigure } from './reach_figure.js';

/** @import { View } from './cell_view.js' */
/** @import { Arm, Hello } from './messages' */

export class ChosenArm {
  #view;
  #robot = '';
  /** @type {Hello['reaches']} */
  #reaches = {};
  /** @type {Map<string, Arm>} */
  #newest = new Map(); // of each arm
  /** @type {ArmFigure | null} */
  #arm = null;
  /** @type {ReachFigure | null} */
  #reach = null;

  /** @param {View} view */
  constructor(view) {
    this.#view = view;
  }

  get grip() {
    return this.#arm?.grip;
  }
  /** @param {Pick<Hello, 'reaches'>} cell */
  setCell({ reaches }) {
    this.#reaches = reaches;
  }
  /** @param {string} robot */
  choose(robot) {
    this.#robot = robot;
    for (const figure of [this.#arm, this.#reach]) if (figure) this.#view.scene.remove(figure.group);
    this.#arm = null;
    this.#reach = this.#reaches[robot] ? new ReachFigure(this.#reaches[robot]) : null;
    if (this.#reach) this.#view.scene.add(this.#reach.group);
    this.#view.says('reach', Boolean(this.#reach));
    this.#view.says('arm', robot);
    const newest = this.#newest.get(robot);
    if (newest) this.#draw(newest);
    this.#view.ask();
  }
  /** @param {Arm} message */
  move(message) {
    this.#newest.set(message.arm, message);
    if (message.arm === this.#robot) this.#draw(message);
  }
  /** @param {number | undefined} opening of the gripper, mm */
  open(opening) {
    if (this.#arm?.open(opening)) this.#view.ask();
  }
  step() {
    return this.#arm?.step() ?? false;
  }

  /** @param {Arm} message */
  #draw(message) {
    if (!this.#arm) {
      this.#arm = new ArmFigure();
      this.#view.scene.add(this.#arm.group);
    }
    this.#arm.goTo(message);
    this.#reach?.standAt(message.points[0]);
    this.#view.ask();
  }
}
