// Slides. A spring slide shows its value while it is held, by the pointer or by keys, and sends it and goes back to zero
// when it is let go; a setting stays where it is put.

import { element } from './dom.js';

/** @import { Attributes } from './dom.js' */

/** @typedef {{ label: string, unit: string, most: number, form: (value: number) => string }} Spring */
/** @typedef {Spring & { least: number, value: number }} Setting */

const steps = /^(Arrow\w+|Page\w+|Home|End)$/;

/** @param {string} label @param {string} unit @param {Attributes} range */
function rowOf(label, unit, range) {
  const shown = element('output', {}, '');
  const input = element('input', { type: 'range', 'aria-label': label, ...range });
  const show = () => {
    shown.textContent = `${input.value} ${unit}`;
    input.setAttribute('aria-valuetext', shown.textContent);
  };
  input.addEventListener('input', show);
  show();
  return { row: element('label', { class: 'slide' }, element('span', {}, label), input, shown), input, show };
}

// Says `letGo` once the pointer or the last key is up, and `drop` where the hand leaves without that. By Escape it leaves,
// though the pointer may still be down and move.
/** @param {HTMLInputElement} input @param {{ letGo: () => void, drop: () => void }} hand */
function follow(input, { letGo, drop }) {
  let by = ''; // what holds it
  let left = false; // by Escape, with the pointer down
  /** @param {string} what */
  const hold = (what) => {
    by = what;
    left = false;
  };
  const leave = () => {
    by = '';
    drop();
  };
  input.addEventListener('pointerdown', () => hold('pointer'));
  input.addEventListener('keydown', ({ key }) => {
    if (steps.test(key)) hold('key');
    if (key !== 'Escape') return;
    left = by === 'pointer';
    leave();
  });
  const end = () => {
    by = '';
    if (left) drop();
    else letGo();
    left = false;
  };
  // Each step of a key is a change to the browser, too.
  input.addEventListener('change', () => by !== 'key' && end());
  input.addEventListener('keyup', () => by === 'key' && end());
  input.addEventListener('pointerup', () => (by = ''));
  for (const loss of ['pointercancel', 'blur']) input.addEventListener(loss, leave);
  return () => by !== '';
}

// Where the hand leaves without letting go in the slide, nothing is sent.
/** @param {Spring} slide @param {(form: string) => void} send */
export function springSlide({ label, unit, most, form }, send) {
  const { row, input, show } = rowOf(label, unit, { min: -most, max: most, step: 1, value: 0 });
  const spring = () => {
    const value = Number(input.value);
    input.value = '0';
    show();
    return value;
  };
  const letGo = () => {
    const value = spring();
    if (value !== 0) send(form(value));
  };
  follow(input, { letGo, drop: spring });
  return { row, input };
}

// `put` shows what the board says, except under the hand.
/** @param {Setting} slide @param {(form: string) => void} send */
export function settingSlide({ label, unit, least, most, value, form }, send) {
  const { row, input, show } = rowOf(label, unit, { min: least, max: most, step: 1, value });
  let told = value;
  const showTold = () => {
    input.value = String(told);
    show();
  };
  const isHeld = follow(input, { letGo: () => send(form(Number(input.value))), drop: showTold });
  /** @param {number} given */
  const put = (given) => {
    told = given;
    if (!isHeld()) showTold();
  };
  return { row, input, put };
}
