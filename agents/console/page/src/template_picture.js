// The template of a learned sample as a picture: 32 x 32 levels, a hexadecimal digit each, 15 where the mark is.

import { element, penOn } from './dom.js';

const side = 32;

/** @param {string} digits @param {string} tone @param {string} label */
export function templatePicture(digits, tone, label) {
  const canvas = element('canvas', { class: 'template', width: side, height: side, role: 'img', 'aria-label': label });
  if (!/^[0-9a-f]{1024}$/.test(digits)) return canvas;
  const context = penOn(canvas);
  const pixels = context.createImageData(side, side);
  for (let i = 0; i < side * side; ++i) {
    const mark = parseInt(digits[i], 16) / 15;
    const level = Math.round(255 * (tone === 'light' ? mark : 1 - mark));
    pixels.data.set([level, level, level, 255], 4 * i);
  }
  context.putImageData(pixels, 0, 0);
  return canvas;
}
