// The arm in hand: jogs, spring slides, and the operations that need no number. Nothing here moves an arm that is not in
// these hands: its agent refuses who is not its commander.

import { CommandLog } from './command_log.js';
import { element, failureText, find } from './dom.js';
import { fact } from './live_answers.js';
import { makeJog } from './jog.js';
import { settingSlide, springSlide } from './slides.js';
import { sym, text, write } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Hands } from './hands.js' */
/** @import { Setting, Spring } from './slides.js' */

/** @param {string} operation @param {string} positive @param {string} negative @returns {(v: number) => string} */
const pair = (operation, positive, negative) => (v) =>
  `(${operation} ${v > 0 ? positive : negative} ${Math.abs(v)})`;
/** @type {Spring[]} */
const slides = [
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
/** @type {Setting} */
const gripper = { label: 'Gripper', unit: 'mm', least: 0, most: 100, value: 80, form: (v) => `(gripper ${v})` };
/** @type {Setting} */
const speed = { label: 'Speed', unit: '%', least: 1, most: 100, value: 50, form: (v) => `(speed ${v})` };

// Where the axes are, as MONITOR answers, live.
/** @param {Connection} connection @param {Hands} hands */
function showAxes(connection, hands) {
  const row = element('output', { class: 'axes', 'aria-label': 'Axis positions' }, 'no arm has told its joints yet');
  connection.follow('(arm-joints ?robot ?joints)', (answers) => {
    const told = answers.map(fact).find((joints) => text(joints[1]) === hands.robot);
    if (told) row.textContent = told[2].map((/** @type {number} */ value, /** @type {number} */ i) => `j${i + 1} ${value.toFixed(1)}`).join('   ');
  });
  return row;
}

// SAVE and GOTO, with the names of what was saved.
/** @param {Connection} connection @param {Hands} hands @param {CommandLog} log */
function variablesForm(connection, hands, log) {
  const known = element('datalist', { id: 'variables' });
  const name = element('input', {
    id: 'variable',
    list: 'variables',
    maxlength: 32,
    size: 12,
    spellcheck: 'false',
    placeholder: 'p1',
    'aria-label': 'Name of a place',
    pattern: '[a-z][a-z0-9\\-]*',
    title: 'a letter, then letters, digits and hyphens',
  });
  /** @param {string} operation */
  const send = (operation) => () => name.value && name.reportValidity() && log.send(`(${operation} ${name.value})`);
  const save = element('button', { type: 'button', onclick: send('learn') }, 'Save');
  const go = element('button', { type: 'button', onclick: send('goto') }, 'Go to');
  connection.follow('(robot-variable ?robot ?name ?joints)', (answers) => {
    const names = answers.map(fact).filter((saved) => text(saved[1]) === hands.robot);
    known.replaceChildren(...names.map((saved) => element('option', { value: text(saved[2]) })));
  });
  return { parts: [name, known, save, go], name, save, go };
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

// The robot's service: whether its agent is there, and moves the arm or has given it back to the people beside it. Why
// nothing moves now is `why`, '' where something may.
/** @param {Connection} connection @param {Hands} hands @param {() => void} changed */
function showService(connection, hands, changed) {
  const light = element('span', { id: 'service-light', class: 'chip', role: 'status' });
  /** @type {Set<string>} */
  let present = new Set();
  /** @type {Map<string, string>} */
  let released = new Map();
  const why = () => {
    if (!present.has(hands.robot)) return 'No robot is present';
    return released.has(hands.robot) ? `${released.get(hands.robot)} released control: get it first` : '';
  };
  const show = () => {
    light.textContent = why() || 'In service';
    light.className = `chip ${why() ? 'bad' : 'good'}`;
    changed();
  };
  connection.followAlways('(agent ?name robot ?host)', (answers) => {
    present = new Set(answers.map((answer) => text(fact(answer)[1])));
    show();
  });
  connection.followAlways('(robot-released ?robot ?client)', (answers) => {
    released = new Map(answers.map((answer) => [text(fact(answer)[1]), text(fact(answer)[2])]));
    show();
  });
  hands.onChange(show);
  return { light, why };
}

// `moving` need an arm that is in service, too.
/** @typedef {HTMLButtonElement | HTMLInputElement} Control */
/** @param {Hands} hands @param {Control[]} controls @param {Set<Control>} moving @param {() => string} why */
function gate(hands, controls, moving, why) {
  for (const control of controls) control.dataset.title = control.title;
  return () => {
    for (const control of controls) {
      const reason = hands.why || (moving.has(control) ? why() : '');
      control.disabled = reason !== '';
      control.title = reason || (control.dataset.title ?? '');
    }
  };
}

/** @param {Hands} hands */
function takeButton(hands) {
  const note = element('span', { class: 'quiet' });
  const take = element('button', { type: 'button', id: 'take-arm', class: 'strong' }, 'Take the arm in hand');
  take.addEventListener('click', () => hands.toggle().catch((failure) => (note.textContent = failureText(failure))));
  const ask = element('button', { type: 'button', id: 'ask-for-arm', hidden: true }, 'Ask for it');
  ask.addEventListener('click', () => hands.toggleWish().catch((failure) => (note.textContent = failureText(failure))));
  hands.onChange((mine, holder) => {
    take.disabled = !hands.live;
    if (!hands.live) {
      note.textContent = `${hands.why}.`;
      return;
    }
    ask.hidden = mine || holder === '';
    ask.textContent = hands.asking ? 'Ask no more' : 'Ask for it';
    take.textContent = mine ? 'Let the arm go' : holder ? `Take over from ${holder}` : 'Take the arm in hand';
    note.textContent = mine
      ? 'Only you move the arm now.'
      : holder
        ? hands.asking ? `${holder} is asked for it.` : ''
        : 'Anybody may move the arm: a goal, a prompt.';
  });
  return element('div', { class: 'row' }, take, ask, note);
}

/** @param {Connection} connection @param {Hands} hands */
export function showDrive(connection, hands) {
  const log = new CommandLog(
    connection,
    () => hands.robot,
    () => hands.me,
    'Commands that the arm received, newest first',
  );
  /** @param {string} form */
  const send = (form) => log.send(form);
  /** @param {string} label @param {string} form */
  const button = (label, form) => element('button', { type: 'button', onclick: () => send(form) }, label);
  const poses = [button('Home', '(home)'), button('Ready', '(ready)')];
  const service = [button('Get control', '(get-control)'), button('Release control', '(release-control)')];
  // Open to all.
  const questions = [
    button('Monitor', '(monitor)'),
    button('Finish: report', '(finish report)'),
    button('Finish: stop', '(finish stop)'),
    button('Status', '(get-status)'),
  ];
  const jog = makeJog(connection, hands, log);
  const springs = slides.map((slide) => springSlide(slide, send));
  const opening = settingSlide(gripper, send);
  const percent = settingSlide(speed, send);
  const variables = variablesForm(connection, hands, log);
  const action = actionForm(log);
  const moving = [
    ...poses,
    ...jog.buttons,
    ...[...springs, opening].map((slide) => slide.input),
    variables.go,
    ...action.controls,
  ];
  const still = [...service, percent.input, variables.name, variables.save];
  let show = () => {};
  const { light, why } = showService(connection, hands, () => show());
  show = gate(hands, [...moving, ...still], new Set(moving), why);

  find('drive').append(
    takeButton(hands),
    element('div', { class: 'row' }, light, ...service, ...poses),
    element('div', { class: 'row' }, ...questions),
    element(
      'div',
      { class: 'driving' },
      element('div', {}, ...jog.parts),
      element('div', { class: 'slides' }, ...springs.map((slide) => slide.row), opening.row, percent.row),
    ),
    element('div', { class: 'row' }, ...variables.parts, showAxes(connection, hands)),
    action.form,
    element('h2', {}, 'Commands received'),
    log.list,
  );
  show();
  connection.follow('(robot-speed ?robot ?percent)', (answers) => {
    const told = answers.map(fact).find((row) => text(row[1]) === hands.robot);
    if (told) percent.put(told[2]);
  });
  connection.follow('(gripper ?robot ?opening)', (answers) => {
    const told = answers.map(fact).find((row) => text(row[1]) === hands.robot);
    if (told) opening.put(Math.round(told[2]));
  });
}
