// A line between a browser and a console, whose connections fall silent or end. What goes through a silent one waits until
// it is restored. One ends in order, or breaks off (RST). They are told apart by the path that they ask for. While the
// line is out of order, whatever connects breaks off.
//
//   const line = await losingLine(port);              the browser maps the console's port to line.port
//   line.lose(pageOnly); line.restore(); line.cut(); line.breakOff(lanesOnly);
//   line.outOfOrder = true;

import { connect, createServer } from 'node:net';

export const all = /^/;
export const pageOnly = /^\/socket$/; // the page's own connection
export const lanesOnly = /^\/socket\/\d+$/; // those of images

// What is told of a connection by the first lines of its newest request.
const asksFor = (bytes) => bytes.toString('latin1').match(/^GET (\S+) HTTP/)?.[1];

export async function losingLine(port) {
  const links = new Set();
  const relay = createServer({ noDelay: true }, (near) => {
    if (line.outOfOrder) return near.resetAndDestroy();
    const far = connect({ host: '127.0.0.1', port, noDelay: true });
    const link = { ends: [near, far], path: '' };
    links.add(link);
    near.on('data', (bytes) => (link.path = asksFor(bytes) ?? link.path));
    for (const end of link.ends) {
      end.on('error', () => end.destroy());
      end.on('close', () => links.delete(link));
    }
    near.pipe(far).pipe(near);
  });
  await new Promise((listening) => relay.listen(0, '127.0.0.1', listening));
  const each = (paths, does) => {
    const chosen = [...links].filter(({ path }) => paths.test(path));
    for (const { ends } of chosen) ends.forEach(does);
    return chosen.length;
  };
  const line = {
    outOfOrder: false,
    port: relay.address().port,
    lose: (paths = all) => each(paths, (end) => end.pause()),
    restore: (paths = all) => each(paths, (end) => end.resume()),
    cut: (paths = all) => each(paths, (end) => end.destroy()),
    breakOff: (paths = all) => each(paths, (end) => end.resetAndDestroy()),
    count: (paths = all) => each(paths, () => {}),
    end: () => relay.close(),
  };
  return line;
}
