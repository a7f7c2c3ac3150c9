// Where calibration boards stood in one camera's image: those that were taken, the one of the newest image, and the parts
// of the image that none came to.
//
//   const view = new BoardOutlines(0);             the left image
//   view.show({ width, height, taken, newest, lacks, isPair })

import { element, penOn } from './dom.js';

/** @import { Form } from './messages' */

/** Outlines are x y x y ..., of each image of a board.
 * @typedef {{ width: number, height: number, taken: number[][][], newest: number[][], lacks: Form[], isPair: boolean }} Seen */

const parts = 3; // each way
const mostPixels = 8192; // each way: anybody may tell such facts
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

export class BoardOutlines {
  #side;
  #canvas = element('canvas', { role: 'img' });
  #label = element('small', {});
  panel = element('div', { class: 'boards' }, this.#canvas, this.#label);

  /** @param {number} side 0: the left image, or the only one */
  constructor(side) {
    this.#side = side;
  }

  /** @param {Seen} seen */
  show({ width, height, taken, newest, lacks, isPair }) {
    const side = this.#side;
    const drawable = [width, height].every((size) => size > 0 && size <= mostPixels);
    this.panel.hidden = !drawable || !taken.some((board) => side in board);
    if (this.panel.hidden) return;
    this.#label.textContent = `Boards in the ${isPair ? ['left ', 'right '][side] : ''}image`;
    this.#canvas.setAttribute('aria-label', this.#label.textContent);
    Object.assign(this.#canvas, { width, height });
    drawParts(this.#canvas, lacks.map(([, , part]) => part).filter(([image]) => image === side));
    for (const board of taken) if (side in board) trace(this.#canvas, board[side], colours.taken, 2);
    if (side in newest) trace(this.#canvas, newest[side], colours.now, 4);
  }
}
