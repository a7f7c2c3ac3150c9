// The arm's slides: springs that move it by what they show, the gripper's opening and the speed, which stay where they are.

import { fact } from './live_answers.js';
import { settingSlide, springSlide } from './slides.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Hands } from './hands.js' */
/** @import { Setting, Spring } from './slides.js' */

/** @param {string} operation @param {string} positive @param {string} negative @returns {(v: number) => string} */
const pair = (operation, positive, negative) => (v) =>
  `(${operation} ${v > 0 ? positive : negative} ${Math.abs(v)})`;
/** @type {Spring[]} */
const motions = [
  {
    label: 'Retract / extend',
    unit: 'mm',
    most: 100,
    form: (v) => (v > 0 ? `(extend keep-height ${v})` : `(retract ${-v})`),
  },
  { label: 'Turn left / right', unit: '°', most: 45, form: pair('turn', 'right', 'left') },
  { label: 'Move left / right', unit: 'mm', most: 100, form: pair('move-h', 'right', 'left') },
  { label: 'Move down / up', unit: 'mm', most: 100, form: pair('move-v', 'up', 'down') },
  { label: 'Tool down / up', unit: '°', most: 45, form: pair('turn-ef', 'up', 'down') },
  { label: 'Wrist left / right', unit: '°', most: 90, form: pair('turn-wrist', 'right', 'left') },
];
// By so much more or less than it is open now.
/** @param {() => number} opening @returns {Spring} */
const gripperStep = (opening) => ({
  label: 'Gripper close / open',
  unit: 'mm',
  most: 60,
  form: (v) => `(gripper ${Math.max(0, Math.round(opening() + v))})`,
});
/** @type {Setting} */
const gripper = { label: 'Gripper opening', unit: 'mm', least: 0, most: 100, value: 80, form: (v) => `(gripper ${v})` };
/** @type {Setting} */
const speed = { label: 'Speed', unit: '%', least: 1, most: 100, value: 50, form: (v) => `(speed ${v})` };

// `moving`: those that move something.
/** @param {Connection} connection @param {Hands} hands @param {(form: string) => void} send */
export function armSlides(connection, hands, send) {
  let measured = gripper.value;
  const springs = [...motions, gripperStep(() => measured)].map((slide) => springSlide(slide, send));
  const opening = settingSlide(gripper, send);
  const percent = settingSlide(speed, send);
  /** @param {string} query @param {(value: number) => void} put */
  const follow = (query, put) =>
    connection.follow(query, (answers) => {
      const told = answers.map(fact).find((row) => text(row[1]) === hands.robot);
      if (told) put(told[2]);
    });
  follow('(robot-speed ?robot ?percent)', percent.put);
  follow('(gripper ?robot ?opening)', (value) => {
    measured = value;
    opening.put(Math.round(value));
  });
  return {
    rows: [...springs, opening, percent].map((slide) => slide.row),
    moving: [...springs, opening].map((slide) => slide.input),
    speed: percent.input,
  };
}
