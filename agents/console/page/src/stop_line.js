// A STOP on its way to the console. It goes two ways, the page's connection and an image's, so that neither a lost packet
// nor a dead line on one of them holds it back; the console counts it once. A connection may end before the STOP is
// acknowledged. Then it is not known whether it was heard, and the next connection says it again.
//
//   await stops.stop("the operator's STOP", (failure) => ...);     has been told; the failures are those of a line
//   stops.open();                                                   there is a connection again

import { gone } from './requests.js';
import { sym, write } from './datum.js';

/** @import { ImageLanes } from './image_lanes.js' */
/** @import { Failure } from './messages' */
/** @import { Line } from './questions.js' */
/** @import { Requests } from './requests.js' */

export class StopLine {
  #line;
  #requests;
  #lanes;
  /** @type {Promise<any> | null} */
  #waiting = null; // the one that the next connection says, however often it was pressed
  open = () => {};

  /** @param {Line} line @param {Requests} requests @param {ImageLanes} lanes */
  constructor(line, requests, lanes) {
    this.#line = line;
    this.#requests = requests;
    this.#lanes = lanes;
  }

  /** @param {string} reason @param {(failure: Failure) => void} unheard @returns {Promise<any>} */
  async stop(reason, unheard) {
    try {
      return await this.#say(reason);
    } catch (failure) {
      if (failure !== gone && failure !== this.#line.notConnected) throw failure;
      unheard(failure);
      this.#waiting ??= this.#sayLater(reason, unheard);
      return this.#waiting;
    }
  }

  /** @param {string} reason */
  #say(reason) {
    const number = this.#line.number();
    this.#lanes.say(write([sym('stop'), number, reason]));
    return this.#requests.callAs(number, null, 'stop', reason);
  }
  /** @param {string} reason @param {(failure: Failure) => void} unheard */
  async #sayLater(reason, unheard) {
    await new Promise((opened) => (this.open = () => opened(null)));
    this.#waiting = null;
    return this.stop(reason, unheard);
  }
}
