// A click in the camera's image turns the head to what is there, while its box is ticked and the head tells how it is
// turned.

import { element } from './dom.js';
import { fact } from './live_answers.js';

/** @import { Connection } from './connection.js' */
/** @import { Images } from './images.js' */
/** @import { Form, PointInImage } from './messages' */

// How far off the middle a pixel is, degrees, positive to the right and upwards.
/** @param {Form} model @param {PointInImage} at */
function offMiddle(model, at) {
  const [, , , , focal, cx, cy] = model;
  /** @param {number} px */
  const degrees = (px) => (Math.atan(px / focal) * 180) / Math.PI;
  return { pan: degrees(at.x - cx), tilt: -degrees(at.y - cy) };
}

// Answers the box.
/** @param {Connection} connection @param {Images} images @param {(form: string) => void} send */
export function clickToLook(connection, images, send) {
  const box = element('input', { type: 'checkbox', id: 'click-to-look' });
  /** @type {Form | undefined} */
  let head;
  /** @type {Form | undefined} */
  let model;
  connection.follow('(head ?pan ?tilt ?state)', ([answer]) => (head = answer && fact(answer)));
  connection.follow('(camera-model ?eyes ?width ?height ?focal ?cx ?cy ?base)', ([answer]) => (model = answer && fact(answer)));
  images.onPoint((at) => {
    if (!box.checked || !head || !model) return false;
    const off = offMiddle(model, at);
    send(`(set-pan-pos ${(head[1] + off.pan).toFixed(2)})`);
    send(`(set-tilt-pos ${(head[2] + off.tilt).toFixed(2)})`);
    return true;
  });
  return box;
}
