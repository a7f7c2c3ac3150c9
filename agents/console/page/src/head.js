// The head that the cameras stand on, where the cell has one: slides, places, speeds, resets, and to look where the
// image is clicked.

import { clickToLook } from './click_to_look.js';
import { CommandLog } from './command_log.js';
import { element, find } from './dom.js';
import { fact } from './live_answers.js';
import { Reasons } from './reasons.js';
import { settingSlide, springSlide } from './slides.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Images } from './images.js' */
/** @import { Permission } from './permission.js' */
/** @import { Form } from './messages' */

const axes = [
  { name: 'pan', label: 'Pan left / right', index: 1 },
  { name: 'tilt', label: 'Tilt down / up', index: 2 },
];

// An axis: a spring slide for a step, a field for a place, its speed and its reset.
/** @param {{ name: string, label: string }} axis @param {(form: string) => void} send */
function axisControls({ name, label }, send) {
  const spring = springSlide({ label, unit: '°', most: 30, form: (v) => `(set-${name}-rel-pos ${v})` }, send);
  const percent = settingSlide(
    {
      label: `${label.split(' ')[0]} speed`,
      unit: '%',
      least: 1,
      most: 100,
      value: 20,
      form: (v) => `(set-${name}-speed ${v})`,
    },
    send,
  );
  const place = element('input', {
    type: 'number',
    id: `${name}-place`,
    step: 'any',
    required: true,
    size: 6,
    'aria-label': `${name} to, degrees`,
  });
  const go = element('button', { type: 'submit' }, 'Move to');
  const reset = element('button', { type: 'button', onclick: () => send(`(reset-${name})`) }, `Reset ${name}`);
  const form = element('form', { class: 'row' }, element('label', { for: place.id }, name), place, '°', go, reset);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    send(`(set-${name}-pos ${Number(place.value)})`);
  });
  return { rows: [spring.row, percent.row], form, percent, controls: [spring.input, percent.input, place, go, reset] };
}

// Where the head looks, and how fast it turns: its speeds are shown by the slides of these axes.
/** @param {Connection} connection @param {ReturnType<typeof axisControls>[]} parts */
function showWhere(connection, parts) {
  const where = element('output', { 'aria-label': 'Where the head looks' }, '');
  connection.follow('(head ?pan ?tilt ?state)', ([answer]) => {
    const [, pan, tilt, state] = answer ? fact(answer) : [];
    where.textContent = answer ? `pan ${pan.toFixed(1)}°, tilt ${tilt.toFixed(1)}°, ${text(state)}` : '';
  });
  connection.follow('(head-speed ?pan ?tilt)', ([answer]) => {
    if (answer) axes.forEach((axis, i) => parts[i].percent.put(fact(answer)[axis.index]));
  });
  return where;
}

/** @param {Connection} connection @param {Permission} permission @param {Images} images @param {() => string} me */
export function showHead(connection, permission, images, me) {
  const log = new CommandLog(connection, () => 'pan-tilt', me, 'Commands that the head received, newest first');
  /** @param {string} form */
  const send = (form) => log.send(form);
  const light = element('span', { id: 'head-light', class: 'chip' }, 'no head is present');
  const parts = axes.map((axis) => axisControls(axis, send));
  /** @param {string} label @param {string} form */
  const button = (label, form) => element('button', { type: 'button', onclick: () => send(form) }, label);
  const buttons = [
    button('Connect', '(pt-init)'),
    button('Disconnect', '(pt-close)'),
    button('Reset both', '(reset-all)'),
    button('Look ahead', '(look-ahead)'),
  ];
  const clicks = clickToLook(connection, images, send);
  const controls = [...buttons, clicks, ...parts.flatMap((part) => part.controls)];
  const reasons = new Reasons('why-head');
  find('head').append(
    element('div', { class: 'row' }, light, showWhere(connection, parts), ...buttons),
    reasons.note,
    element('div', { class: 'slides' }, ...parts.flatMap((part) => part.rows)),
    ...parts.map((part) => part.form),
    element('label', { class: 'row' }, clicks, 'A click in the camera’s image turns the head there'),
    element('h2', {}, 'Commands received'),
    log.list,
  );

  /** @type {Form | undefined} */
  let told;
  const show = () => {
    const state = told ? text(told[1]) : 'no head is present';
    light.textContent = told && text(told[2]) ? `${state}: ${text(told[2])}` : state;
    light.className = `chip ${state === 'ready' ? 'good' : 'bad'}`;
    const absent = told ? '' : 'This cell has no head that turns, or its agent is away';
    reasons.set('Whatever turns the head', controls, permission.command('request') || absent);
  };
  permission.onChange(show);
  connection.follow('(pan-tilt ?state ?trouble)', ([answer]) => {
    told = answer && fact(answer);
    show();
  });
}
