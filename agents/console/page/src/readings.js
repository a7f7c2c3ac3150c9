// Where the robot is, in numbers: (arm-pose ROBOT X Y Z RX RY RZ), (arm-joints ROBOT (J ...)), (gripper ROBOT OPENING) and
// (arm ROBOT STATE ACTION) in words.
//
//   const readings = new Readings(connection, (opening) => ...);     who draws the gripper
//   readings.show('robot');

import { element, find } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Form } from './messages' */

/** @param {string} action */
const rounded = (action) => action.replace(/\d+\.\d+/g, (number) => String(Math.round(Number(number) * 10) / 10));
/** @param {number[]} numbers */
const row = (numbers) => numbers.map((v) => v.toFixed(0)).join('  ');

/** @type {Record<string, (told: Form) => [label: string, value: string][]>} */
const words = {
  pose: ([, , ...pose]) => [
    ['grip', `${row(pose.slice(0, 3))} mm`],
    ['turned', `${row(pose.slice(3))} °`],
  ],
  joints: ([, , joints]) => [['joints', row(joints)]],
  gripper: ([, , opening]) => [['gripper', `${opening.toFixed(0)} mm`]],
  arm: ([, , state, action]) => [['arm', `${text(state)}  ${rounded(text(action)).slice(0, 40)}`]],
};

export class Readings {
  #robot = 'robot';
  /** @type {Record<string, Form[]>} */
  #told = {};
  #opened;

  /** @param {Connection} connection @param {(opening: number | undefined) => void} opened */
  constructor(connection, opened) {
    this.#opened = opened;
    /** @param {string} name @param {string} query */
    const follow = (name, query) =>
      connection.follow(query, (answers) => {
        this.#told[name] = answers.map(fact);
        this.#draw();
      });
    follow('pose', '(arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz)');
    follow('joints', '(arm-joints ?robot ?joints)');
    follow('gripper', '(gripper ?robot ?opening)');
    follow('arm', '(arm ?robot ?state ?action)');
  }

  /** @param {string} robot */
  show(robot) {
    this.#robot = robot;
    this.#draw();
  }

  /** @param {string} name */
  /** @param {string} name */
  #of(name) {
    return this.#told[name]?.find((told) => text(told[1]) === this.#robot);
  }
  #draw() {
    const rows = Object.entries(words).flatMap(([name, say]) => {
      const told = this.#of(name);
      return told ? say(told) : [];
    });
    find('readings').replaceChildren(
      ...rows.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]),
    );
    this.#opened(this.#of('gripper')?.[2]);
  }
}
