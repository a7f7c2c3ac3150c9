// A calibration that goes on, as `./pizarra calibrate --tell` tells of it: where the boards stood that were taken, where
// the board stands now, and what is still missing, in words and as the parts of the image that no board came to.

import { clipped, element, penOn } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Form } from './messages' */

/** @type {Record<string, string>} */
const states = { looking: 'looking for boards', fitting: 'fitting', done: 'done', failed: 'failed' };
/** @type {Record<string, string>} */
const kinds = { done: 'good', failed: 'bad' };
const parts = 3; // each way
// Anybody may tell such facts.
const mostBoards = 64;
const mostLacks = 32;
const mostPixels = 8192; // each way
const colours = { missing: '#4b3a17', grid: '#2a3b47', taken: '#7fd18b', now: '#f2a33a' };

/** @param {HTMLCanvasElement} canvas @param {number[]} outline @param {string} colour @param {number} width */
function trace(canvas, outline, colour, width) {
  const pen = penOn(canvas);
  pen.strokeStyle = colour;
  pen.lineWidth = width;
  pen.beginPath();
  for (let i = 0; i + 1 < outline.length; i += 2) pen.lineTo(outline[i], outline[i + 1]);
  pen.closePath();
  pen.stroke();
}

/** @param {HTMLCanvasElement} canvas @param {Form[]} missing */
function drawParts(canvas, missing) {
  const pen = penOn(canvas);
  const [width, height] = [canvas.width / parts, canvas.height / parts];
  pen.clearRect(0, 0, canvas.width, canvas.height);
  pen.fillStyle = colours.missing;
  for (const [, column, row] of missing) pen.fillRect(column * width, row * height, width, height);
  pen.strokeStyle = colours.grid;
  pen.lineWidth = 1;
  for (let i = 0; i < parts * parts; ++i) pen.strokeRect((i % parts) * width, Math.floor(i / parts) * height, width, height);
}

function makeView() {
  const canvas = element('canvas', { role: 'img' });
  const label = element('small', {});
  return { canvas, label, box: element('div', { class: 'boards' }, canvas, label) };
}

/** @param {Connection} connection */
export function showCalibration(connection) {
  const chip = element('span', { class: 'chip', id: 'calibration-state', role: 'status' });
  const count = element('span', { id: 'calibration-count' });
  const sentence = element('p', { id: 'calibration-sentence', hidden: true });
  const seen = element('span', { class: 'quiet', id: 'calibration-sees' });
  const missing = element('ul', { id: 'calibration-lacks', 'aria-label': 'Still missing' });
  const views = [makeView(), makeView()];
  const panel = element(
    'section',
    { id: 'calibration', 'aria-label': 'Calibration', hidden: true },
    element('div', { class: 'row' }, element('h2', {}, 'Calibration'), chip, count, seen),
    sentence,
    element('div', { class: 'calibrating' }, ...views.map((view) => view.box), missing),
  );
  /** @type {Form | undefined} */
  let now;
  /** @type {number[][][]} */
  let outlines = [];
  /** @type {number[][]} */
  let newest = [];
  /** @type {Form[]} */
  let lacks = [];

  const draw = () => {
    panel.hidden = now === undefined;
    if (now === undefined) return;
    const [, state, said, width, height, boards, wanted] = now;
    const doing = text(state);
    chip.textContent = states[doing] ?? doing;
    chip.className = `chip ${kinds[doing] ?? 'busy'}`;
    count.textContent = `${boards} of ${wanted} boards`;
    sentence.textContent = clipped(text(said), 1000);
    sentence.hidden = sentence.textContent === '';
    const sentences = lacks.map(([, lack]) => clipped(text(lack)));
    missing.replaceChildren(...(sentences.length ? sentences : ['nothing more']).map((one) => element('li', {}, one)));
    const isPair = outlines.some((taken) => 1 in taken);
    views.forEach(({ canvas, label, box }, side) => {
      const drawable = [width, height].every((size) => size > 0 && size <= mostPixels);
      box.hidden = !drawable || !outlines.some((taken) => side in taken);
      if (box.hidden) return;
      label.textContent = `Boards in the ${isPair ? ['left ', 'right '][side] : ''}image`;
      canvas.setAttribute('aria-label', label.textContent);
      Object.assign(canvas, { width, height });
      drawParts(canvas, lacks.map(([, , part]) => part).filter(([image]) => image === side));
      for (const taken of outlines) if (side in taken) trace(canvas, taken[side], colours.taken, 2);
      if (side in newest) trace(canvas, newest[side], colours.now, 4);
    });
  };
  connection.follow('(calibration ?state ?sentence ?width ?height ?boards ?wanted)', (answers) => {
    now = answers.length ? fact(answers[0]) : undefined;
    draw();
  });
  connection.follow('(calibration-board ?number ?outlines)', (answers) => {
    outlines = answers.slice(0, mostBoards).map((answer) => fact(answer)[2]);
    draw();
  });
  connection.follow('(calibration-sees ?outlines ?sentence)', (answers) => {
    newest = answers.length ? fact(answers[0])[1] : [];
    seen.textContent = answers.length ? `the newest image: ${clipped(text(fact(answers[0])[2]))}` : '';
    draw();
  });
  connection.follow('(calibration-lacks ?sentence ?part)', (answers) => {
    lacks = answers.slice(0, mostLacks).map(fact);
    draw();
  });
  return panel;
}
