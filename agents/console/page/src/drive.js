// The arm in hand: jogs, slides, and the operations that need no number. Nothing here moves an arm that is not in
// these hands: its agent refuses who is not its commander.

import { armSlides } from './arm_slides.js';
import { CommandLog } from './command_log.js';
import { element, find } from './dom.js';
import { fact } from './live_answers.js';
import { makeJog } from './jog.js';
import { placesForm } from './places.js';
import { Reasons } from './reasons.js';
import { showService } from './service.js';
import { sym, text, write } from './datum.js';
import { takeArm } from './take_arm.js';

/** @import { Axes } from './axis_names.js' */
/** @import { Connection } from './connection.js' */
/** @import { Hands } from './hands.js' */
/** @import { Permission } from './permission.js' */

// Where the axes are, as MONITOR answers, live.
/** @param {Connection} connection @param {Hands} hands @param {Axes} axes */
function showAxes(connection, hands, axes) {
  const row = element('output', { class: 'axes', 'aria-label': 'Axis positions' }, 'no arm has told its joints yet');
  connection.follow('(arm-joints ?robot ?joints)', (answers) => {
    const told = answers.map(fact).find((joints) => text(joints[1]) === hands.robot);
    if (told) row.textContent = axes.words(hands.robot, told[2]).map((axis) => axis.join(' ').replaceAll(' ', '\u00a0')).join('   ');
  });
  return row;
}

/** @param {CommandLog} log */
function actionForm(log) {
  const input = element('input', {
    id: 'action',
    maxlength: 4000,
    spellcheck: 'false',
    placeholder: '(move 350 0 300)   or   CIRCLE p1, p2, p3',
    'aria-label': 'Action',
  });
  const go = element('button', { type: 'submit' }, 'Do action');
  const form = element('form', { class: 'row' }, input, go);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    if (input.value) log.send(write([sym('do-action'), input.value]));
  });
  return { form, controls: [input, go] };
}

// The controls: `moving` need an arm that is in service, too; `questions` are open to all.
/** @param {Connection} connection @param {Hands} hands @param {CommandLog} log */
function makeControls(connection, hands, log) {
  /** @param {string} form */
  const send = (form) => log.send(form);
  /** @param {string} label @param {string} form */
  const button = (label, form) => element('button', { type: 'button', onclick: () => send(form) }, label);
  const poses = [button('Home', '(home)'), button('Ready', '(ready)')];
  const service = [button('Get control', '(get-control)'), button('Release control', '(release-control)')];
  const questions = [
    button('Monitor', '(monitor)'),
    button('Finish: report', '(finish report)'),
    button('Finish: stop', '(finish stop)'),
    button('Status', '(get-status)'),
  ];
  const jog = makeJog(connection, hands, log);
  const slides = armSlides(connection, hands, send);
  const places = placesForm(connection, hands, log);
  const action = actionForm(log);
  const moving = [...poses, ...slides.moving, places.go, ...action.controls];
  const still = [...service, slides.speed, places.name, places.save];
  return { poses, service, questions, jog, slides, places, action, moving, still };
}

/** @param {{ connection: Connection, permission: Permission, hands: Hands, axes: Axes }} around */
export function showDrive({ connection, permission, hands, axes }) {
  const log = new CommandLog(
    connection,
    () => hands.robot,
    () => hands.me,
    'Commands that the arm received, newest first',
  );
  const { poses, service, questions, jog, slides, places, action, moving, still } = makeControls(connection, hands, log);
  const reasons = new Reasons('why-drive');
  let show = () => {};
  const { light, why } = showService(connection, hands, () => show());
  show = () => {
    reasons.set('Jogs', jog.buttons, permission.right('jog') || hands.why || why());
    reasons.set('Slides, poses and actions', moving, hands.why || why());
    reasons.set('Speed, places and control', still, hands.why);
    reasons.set('Questions and Finish', questions, permission.line || permission.right('request'));
  };
  find('drive').append(
    ...takeArm(hands, permission),
    reasons.note,
    element('div', { class: 'row' }, light, ...service, ...poses),
    element('div', { class: 'row' }, ...questions),
    element(
      'div',
      { class: 'driving' },
      element('div', {}, ...jog.parts),
      element('div', { class: 'slides' }, ...slides.rows),
    ),
    element('div', { class: 'row' }, ...places.parts, showAxes(connection, hands, axes)),
    action.form,
    element('h2', {}, 'Commands received'),
    log.list,
  );
  show();
}
