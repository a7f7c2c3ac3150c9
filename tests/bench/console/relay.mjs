// node relay.mjs FROM-HOST FROM-PORT TO-HOST TO-PORT: each connection to the one goes on to the other, as one of its own.

import { connect, createServer } from 'node:net';

const [fromHost, fromPort, toHost, toPort] = process.argv.slice(2);
createServer({ noDelay: true }, (near) => {
  const far = connect({ host: toHost, port: Number(toPort), noDelay: true });
  near.pipe(far).pipe(near);
  near.on('error', () => far.destroy());
  far.on('error', () => near.destroy());
}).listen(Number(fromPort), fromHost, () => console.log('ready'));
