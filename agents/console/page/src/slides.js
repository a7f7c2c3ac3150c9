// Slides. A spring slide shows its value while it is held, and sends it and goes back to zero when it is let go; a
// setting stays where it is put.

import { element } from './dom.js';

function rowOf(label, unit, range) {
  const shown = element('output', {}, '');
  const input = element('input', { type: 'range', 'aria-label': label, ...range });
  const show = () => (shown.textContent = `${input.value} ${unit}`);
  input.addEventListener('input', show);
  show();
  return { row: element('label', { class: 'slide' }, element('span', {}, label), input, shown), input, show };
}

// Where the hand leaves without letting go in the slide, nothing is sent.
export function springSlide({ label, unit, most, form }, send) {
  const { row, input, show } = rowOf(label, unit, { min: -most, max: most, step: 1, value: 0 });
  const spring = () => {
    const value = Number(input.value);
    input.value = 0;
    show();
    return value;
  };
  input.addEventListener('change', () => {
    const value = spring();
    if (value !== 0) send(form(value));
  });
  input.addEventListener('pointercancel', spring);
  input.addEventListener('blur', spring);
  return { row, input };
}

// `put` shows what the board says, except under the hand.
export function settingSlide({ label, unit, least, most, value, form }, send) {
  const { row, input, show } = rowOf(label, unit, { min: least, max: most, step: 1, value });
  let held = false;
  input.addEventListener('pointerdown', () => (held = true));
  for (const end of ['pointerup', 'pointercancel']) input.addEventListener(end, () => (held = false));
  input.addEventListener('change', () => send(form(Number(input.value))));
  const put = (given) => {
    if (held) return;
    input.value = given;
    show();
  };
  return { row, input, put };
}
