// A line between a browser and a console on which connections fall silent: what goes through one waits until it is
// restored. They are told apart by the path that they ask for.
//
//   const line = await losingLine(port);              the browser maps the console's port to line.port
//   line.lose(pageOnly); line.restore(); line.cut();

import { connect, createServer } from 'node:net';

export const all = /^/;
export const pageOnly = /^\/socket$/; // the page's own connection
export const lanesOnly = /^\/socket\/\d+$/; // those of images

// What is told of a connection by the first lines of its newest request.
const asksFor = (bytes) => bytes.toString('latin1').match(/^GET (\S+) HTTP/)?.[1];

export async function losingLine(port) {
  const links = new Set();
  const relay = createServer({ noDelay: true }, (near) => {
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
  return {
    port: relay.address().port,
    lose: (paths = all) => each(paths, (end) => end.pause()),
    restore: (paths = all) => each(paths, (end) => end.resume()),
    cut: (paths = all) => each(paths, (end) => end.destroy()),
    count: (paths = all) => each(paths, () => {}),
    end: () => relay.close(),
  };
}
