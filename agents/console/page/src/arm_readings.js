// Where the robot is, in numbers: (arm-pose ROBOT X Y Z RX RY RZ), (arm-joints ROBOT (J ...)), (gripper ROBOT OPENING) and
// (arm ROBOT STATE ACTION) in words.
//
//   const readings = new Readings(connection, axes, (opening) => ...);     who draws the gripper
//   readings.show('robot');

import { element, find, fixed } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Axes } from './axis_names.js' */
/** @import { Connection } from './connection.js' */
/** @import { Form } from './messages' */

const none = 'NO_ACTION'; // so far
/** @param {string} action */
const rounded = (action) => action.replace(/\d+\.\d+/g, (number) => String(Math.round(Number(number) * 10) / 10));
/** @param {number[]} numbers */
const row = (numbers) => numbers.map((v) => fixed(v, 0)).join('  ');

// Those of one unit after another have it once.
/** @param {[name: string, value: string][]} axes */
const brief = (axes) =>
  axes.map(([, value], i) => (value.split(' ')[1] === axes[i + 1]?.[1].split(' ')[1] ? value.split(' ')[0] : value)).join('  ');

/** @type {Record<string, (told: Form, axes: Axes) => [label: string, value: string][]>} */
const words = {
  pose: ([, , ...pose]) => [
    ['grip', `${row(pose.slice(0, 3))} mm`],
    ['turned', `${row(pose.slice(3))} °`],
  ],
  joints: ([, robot, joints], axes) => [['joints', brief(axes.words(text(robot), joints, 0))]],
  gripper: ([, , opening]) => [['gripper', `${opening.toFixed(0)} mm`]],
  arm: ([, , state, action]) => [['arm', text(action) === none ? text(state) : `${text(state)}  ${rounded(text(action)).slice(0, 40)}`]],
};

export class Readings {
  #robot = 'robot';
  /** @type {Record<string, Form[]>} */
  #told = {};
  #axes;
  #opened;

  /** @param {Connection} connection @param {Axes} axes @param {(opening: number | undefined) => void} opened */
  constructor(connection, axes, opened) {
    this.#axes = axes;
    this.#opened = opened;
    axes.onChange(() => this.#draw());
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
  #of(name) {
    return this.#told[name]?.find((told) => text(told[1]) === this.#robot);
  }
  #draw() {
    const rows = Object.entries(words).flatMap(([name, say]) => {
      const told = this.#of(name);
      return told ? say(told, this.#axes) : [];
    });
    find('readings').replaceChildren(
      ...rows.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]),
    );
    this.#opened(this.#of('gripper')?.[2]);
  }
}
