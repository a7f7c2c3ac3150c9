// Connections for images alone, beside the page's own. Each carries one image at a time: where a packet is lost, that
// image comes late, and the others go on coming.
//
//   const lanes = new ImageLanes(async (message) => ...);     // who draws an image, and answers when it has
//   lanes.open({ path: '/socket/7', lanes: 6 });

import { sym, write } from './datum.js';

const pause = 1000; // ms until one that was lost is opened again

export const socketAt = (path) => {
  const socket = new WebSocket(`${location.protocol.replace('http', 'ws')}//${location.host}${path}`);
  socket.binaryType = 'arraybuffer';
  return socket;
};

export class ImageLanes {
  #draw;
  #open = new Set();

  constructor(draw) {
    this.#draw = draw;
  }

  open({ path, lanes }) {
    this.close();
    for (let i = 0; i < lanes; ++i) this.#add(path);
  }
  close() {
    const open = this.#open;
    this.#open = new Set();
    for (const socket of open) socket.close();
  }

  #add(path) {
    const lanes = this.#open;
    const socket = socketAt(path);
    lanes.add(socket);
    socket.onmessage = async ({ data }) => {
      const came = performance.now();
      await this.#draw(data);
      socket.send(write([sym('drawn'), Math.round(performance.now() - came)]));
    };
    socket.onclose = () => {
      lanes.delete(socket);
      setTimeout(() => lanes === this.#open && this.#add(path), pause);
    };
  }
}
