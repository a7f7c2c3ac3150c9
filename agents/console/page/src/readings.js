// Where the arm is, in numbers.

import { element, find } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

const rounded = (action) => action.replace(/\d+\.\d+/g, (number) => String(Math.round(number * 10) / 10));

// (arm-pose ROBOT X Y Z RX RY RZ), (gripper ROBOT OPENING) and (arm ROBOT STATE ACTION), in words.
export function showReadings(connection, moved) {
  const readings = {};
  const show = () => {
    const rows = Object.entries(readings).filter(([, value]) => value);
    find('readings').replaceChildren(
      ...rows.flatMap(([name, value]) => [element('dt', {}, name), element('dd', {}, value)]),
    );
  };
  const of = (answers) => answers.map(fact).find((told) => text(told[1]) === moved.robot);
  connection.follow('(arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz)', (answers) => {
    const pose = of(answers);
    readings.grip =
      pose &&
      `${pose
        .slice(2, 5)
        .map((v) => v.toFixed(0))
        .join('  ')} mm`;
    const turned = pose?.slice(5).map((v) => v.toFixed(0));
    readings.turned = turned && `${turned.join('  ')} °`;
    show();
  });
  connection.follow('(arm-joints ?robot ?joints)', (answers) => {
    const joints = of(answers)?.[2];
    readings.joints = joints && joints.map((v) => v.toFixed(0)).join('  ');
    show();
  });
  connection.follow('(gripper ?robot ?opening)', (answers) => {
    const opening = of(answers)?.[2];
    readings.gripper = opening !== undefined && `${opening.toFixed(0)} mm`;
    moved.open(opening);
    show();
  });
  connection.follow('(arm ?robot ?state ?action)', (answers) => {
    const arm = of(answers);
    readings.arm = arm && `${text(arm[2])}  ${rounded(text(arm[3])).slice(0, 40)}`;
    show();
  });
}
