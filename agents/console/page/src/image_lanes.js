// Connections for images, beside the page's own. Each carries one image at a time: where a packet is lost, that image
// comes late, and the others go on coming. For the same reason what moves the arm or stops it is said on one of them as
// well. One that has become slow is opened anew when the console says so.
//
//   const lanes = new ImageLanes(async (message) => ...);     // who draws an image, and answers when it has
//   lanes.open({ path: '/socket/7', lanes: 6 });
//   lanes.say('(release 12)');

import { sym, write } from './datum.js';

const pause = 1000; // ms until one that was lost is opened again

/** @param {string} path */
export const socketAt = (path) => {
  const socket = new WebSocket(`${location.protocol.replace('http', 'ws')}//${location.host}${path}`);
  socket.binaryType = 'arraybuffer';
  return socket;
};

export class ImageLanes {
  #draw;
  /** @type {Set<WebSocket>} */
  #open = new Set();

  /** @param {(message: ArrayBuffer) => Promise<void>} draw */
  constructor(draw) {
    this.#draw = draw;
  }

  /** @param {{ path: string, lanes: number }} where */
  open({ path, lanes }) {
    this.close();
    for (let i = 0; i < lanes; ++i) this.#add(path);
  }
  close() {
    const open = this.#open;
    this.#open = new Set();
    for (const socket of open) socket.close();
  }
  // Always on the same one, so that it comes in order.
  /** @param {string} message */
  say(message) {
    const open = [...this.#open].find(({ readyState }) => readyState === WebSocket.OPEN);
    open?.send(message);
  }

  /** @param {string} path */
  #add(path) {
    const lanes = this.#open;
    const socket = socketAt(path);
    lanes.add(socket);
    socket.onmessage = async ({ data }) => {
      if (data === '(renew)') return this.#renew(socket);
      const came = performance.now();
      await this.#draw(data);
      if (socket.readyState === WebSocket.OPEN) socket.send(write([sym('drawn'), Math.round(performance.now() - came)]));
    };
    socket.onclose = () => {
      const lost = lanes.delete(socket);
      const soon = lost ? pause : 0; // one that is renewed was taken out before
      setTimeout(() => lanes === this.#open && this.#add(path), soon);
    };
  }
  // What was said on it still comes; what is said from here on goes by another.
  /** @param {WebSocket} socket */
  #renew(socket) {
    this.#open.delete(socket);
    socket.close();
  }
}
