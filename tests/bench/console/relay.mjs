// node relay.mjs FROM-HOST FROM-PORT TO-HOST TO-PORT: connections to the one go on to the other, as `ssh -L` has them.

import { connect, createServer } from 'node:net';

const [fromHost, fromPort, toHost, toPort] = process.argv.slice(2);
createServer({ noDelay: true }, (near) => {
  const far = connect({ host: toHost, port: Number(toPort), noDelay: true });
  near.pipe(far).pipe(near);
  near.on('error', () => far.destroy());
  far.on('error', () => near.destroy());
}).listen(Number(fromPort), fromHost, () => console.log('ready'));
