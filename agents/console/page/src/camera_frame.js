// The frame of the eyes in the cell's: where they are, and which way is right, down and ahead in their image. They look
// along the base's -x, turned by pan towards +y, by tilt upwards, and by roll about their own axis.

import { Vector3 } from 'three';

/** @import { Camera } from './messages' */

/** @typedef {{ pan: number, tilt: number }} Turn */
/** @typedef {ReturnType<typeof cameraFrame>} Frame */

/** @param {number} degrees */
const radians = (degrees) => (degrees * Math.PI) / 180;

/** @param {Camera} camera @param {Turn} turn */
export function cameraFrame({ at, pan, tilt, roll }, turn) {
  const [p, t] = [radians(pan + turn.pan), radians(tilt + turn.tilt)];
  const ahead = new Vector3(-Math.cos(p) * Math.cos(t), Math.sin(p) * Math.cos(t), Math.sin(t));
  const right = new Vector3(Math.sin(p), Math.cos(p), 0).applyAxisAngle(ahead, radians(roll));
  return { eye: new Vector3(...at), right, down: new Vector3().crossVectors(ahead, right), ahead };
}
