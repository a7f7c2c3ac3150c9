// The streams that the page looks at, and their images as they come.
//
//   const end = looks.add('vision-colour', (picture) => ...)

import { ImageLanes } from './image_lanes.js';
import { read, sym, text } from './datum.js';

/** @import { Picture } from './messages' */
/** @import { Line } from './questions.js' */

const longestLate = 5e6; // microseconds

// Of `(image STREAM NUMBER CAPTURED-US WIDTH HEIGHT)` or `(picture REQUEST ...)`, a newline and a JPEG: what it is of, and
// the picture, if it is one.
/** @param {ArrayBuffer} message @returns {Promise<[of: any, picture: Picture | null]>} */
export async function pictureIn(message) {
  const bytes = new Uint8Array(message);
  const end = bytes.indexOf(10);
  const [, of, number, captured, width, height] = read(new TextDecoder().decode(bytes.subarray(0, end)));
  const blob = new Blob([bytes.subarray(end + 1)], { type: 'image/jpeg' });
  const bitmap = await createImageBitmap(blob).catch(() => null);
  return [of, bitmap && { bitmap, number, captured, width, height }];
}

export class Looks {
  #line;
  /** @type {Map<string, (picture: Picture) => void>} */
  #shown = new Map();
  /** @type {Map<string, number>} */
  #newest = new Map(); // of each stream, when what is shown was captured
  lanes = new ImageLanes((message) => this.#draw(message));

  /** @param {Line} line */
  constructor(line) {
    this.#line = line;
  }

  /** @param {{ path: string, lanes: number }} where */
  open(where) {
    this.lanes.open(where);
    for (const name of this.#shown.keys()) this.#line.say(sym('look'), sym(name));
  }
  lost() {
    this.lanes.close();
  }
  /** @param {string} stream @param {(picture: Picture) => void} show */
  add(stream, show) {
    this.#shown.set(stream, show);
    this.#line.say(sym('look'), sym(stream));
    return () => {
      this.#shown.delete(stream);
      this.#line.say(sym('look-away'), sym(stream));
    };
  }

  // Where a newer one is shown already, it came too late. A clock that was set back makes all of them older.
  /** @param {ArrayBuffer} message */
  async #draw(message) {
    const [name, picture] = await pictureIn(message);
    // A hidden page draws nothing, and so is sent nothing.
    await new Promise(requestAnimationFrame);
    if (!picture) return;
    const { captured } = picture;
    const newest = this.#newest.get(text(name)) ?? 0;
    if (captured >= newest || newest - captured > longestLate) {
      this.#newest.set(text(name), captured);
      this.#shown.get(text(name))?.(picture);
    }
    picture.bitmap.close();
  }
}
