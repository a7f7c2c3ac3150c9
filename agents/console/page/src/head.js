// The head that the cameras stand on, where the cell has one: slides, places, speeds, resets, and to look where the
// image is clicked.

import { CommandLog } from './command_log.js';
import { element, find } from './dom.js';
import { fact } from './live_answers.js';
import { Reasons } from './reasons.js';
import { settingSlide, springSlide } from './slides.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Images } from './images.js' */
/** @import { Permission } from './permission.js' */
/** @import { Form, PointInImage } from './messages' */

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

// How far off the middle a pixel is, degrees, positive to the right and upwards.
/** @param {Form} model @param {PointInImage} at */
function offMiddle(model, at) {
  const [, , , , focal, cx, cy] = model;
  /** @param {number} px */
  const degrees = (px) => (Math.atan(px / focal) * 180) / Math.PI;
  return { pan: degrees(at.x - cx), tilt: -degrees(at.y - cy) };
}

/** @param {Connection} connection @param {Permission} permission @param {Images} images @param {() => string} me */
export function showHead(connection, permission, images, me) {
  const panel = find('head');
  const log = new CommandLog(connection, () => 'pan-tilt', me, 'Commands that the head received, newest first');
  /** @param {string} form */
  const send = (form) => log.send(form);
  const light = element('span', { id: 'head-light', class: 'chip' }, 'no head is present');
  const where = element('output', { 'aria-label': 'Where the head looks' }, '');
  const parts = axes.map((axis) => axisControls(axis, send));
  /** @param {string} label @param {string} form */
  const button = (label, form) => element('button', { type: 'button', onclick: () => send(form) }, label);
  const buttons = [
    button('Connect', '(pt-init)'),
    button('Disconnect', '(pt-close)'),
    button('Reset both', '(reset-all)'),
    button('Look ahead', '(look-ahead)'),
  ];
  const clicks = element('input', { type: 'checkbox', id: 'click-to-look' });
  const controls = [...buttons, clicks, ...parts.flatMap((part) => part.controls)];
  const reasons = new Reasons('why-head');
  panel.append(
    element('div', { class: 'row' }, light, where, ...buttons),
    reasons.note,
    element('div', { class: 'slides' }, ...parts.flatMap((part) => part.rows)),
    ...parts.map((part) => part.form),
    element('label', { class: 'row' }, clicks, 'A click in the camera’s image turns the head there'),
    element('h2', {}, 'Commands received'),
    log.list,
  );

  /** @type {Form | undefined} */
  let head;
  /** @type {Form | undefined} */
  let model;
  images.onPoint((at) => {
    if (!clicks.checked || !head || !model) return false;
    const off = offMiddle(model, at);
    send(`(set-pan-pos ${(head[1] + off.pan).toFixed(2)})`);
    send(`(set-tilt-pos ${(head[2] + off.tilt).toFixed(2)})`);
    return true;
  });
  connection.follow('(head ?pan ?tilt ?state)', (answers) => {
    head = answers.length ? fact(answers[0]) : undefined;
    where.textContent = head ? `pan ${head[1].toFixed(1)}°, tilt ${head[2].toFixed(1)}°, ${text(head[3])}` : '';
  });
  connection.follow('(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)', (answers) => {
    const told = answers.length ? fact(answers[0]) : undefined;
    model = told && [...told];
  });
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
  connection.follow('(pan-tilt ?state ?trouble)', (answers) => {
    told = answers.length ? fact(answers[0]) : undefined;
    show();
  });
  connection.follow('(head-speed ?pan ?tilt)', (answers) => {
    if (!answers.length) return;
    axes.forEach((axis, i) => parts[i].percent.put(fact(answers[0])[axis.index]));
  });
}
