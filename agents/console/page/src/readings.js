// Where the robot is, in numbers: (arm-pose ROBOT X Y Z RX RY RZ), (arm-joints ROBOT (J ...)), (gripper ROBOT OPENING) and
// (arm ROBOT STATE ACTION) in words.
//
//   const readings = new Readings(connection, (opening) => ...);     who draws the gripper
//   readings.show('robot');

import { element, find } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

const rounded = (action) => action.replace(/\d+\.\d+/g, (number) => String(Math.round(number * 10) / 10));
const row = (numbers) => numbers.map((v) => v.toFixed(0)).join('  ');

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
  #told = {};
  #opened;

  constructor(connection, opened) {
    this.#opened = opened;
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

  show(robot) {
    this.#robot = robot;
    this.#draw();
  }

  #of(name) {
    return this.#told[name]?.find((told) => text(told[1]) === this.#robot);
  }
  #draw() {
    const rows = Object.keys(words).flatMap((name) => (this.#of(name) ? words[name](this.#of(name)) : []));
    find('readings').replaceChildren(
      ...rows.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]),
    );
    this.#opened(this.#of('gripper')?.[2]);
  }
}
