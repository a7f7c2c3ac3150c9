// A jog on its way to the console: begun, held on to and let go, each with the newest stamp of the server. It goes
// two ways, the page's connection and an image's, so that neither a lost packet nor a dead line on one of them holds it
// back; the console takes what comes first.

import { sym, write } from './datum.js';

/** @import { ImageLanes } from './image_lanes.js' */
/** @import { Datum } from './messages' */
/** @import { Line } from './questions.js' */
/** @import { Requests } from './requests.js' */

export class HeldLine {
  #line;
  #requests;
  #lanes;
  #number = 0; // of the request that the page holds on to
  stamp = 0;

  /** @param {Line} line @param {Requests} requests @param {ImageLanes} lanes */
  constructor(line, requests, lanes) {
    this.#line = line;
    this.#requests = requests;
    this.#lanes = lanes;
  }

  // The arm moves while holdOn() comes in time, and until release(); answers when it has ended.
  /** @param {string} robot @param {string} direction */
  jog(robot, direction) {
    this.#number = this.#line.number();
    const words = [sym(robot), sym(direction), this.stamp];
    this.#repeat('jog', ...words);
    return this.#requests.callAs(this.#number, null, 'jog', ...words);
  }
  holdOn() {
    this.#line.say(sym('hold-on'), this.#number, this.stamp);
    this.#repeat('hold-on', this.stamp);
  }
  release() {
    this.#line.say(sym('release'), this.#number);
    this.#repeat('release');
  }
  /** @param {string} verb @param {Datum[]} rest */
  #repeat(verb, ...rest) {
    this.#lanes.say(write([sym(verb), this.#number, ...rest]));
  }
}
