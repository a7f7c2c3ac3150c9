// node crowd.mjs PIZARRA-CELL SCRATCH: how soon a page of a running cell is alive, and what a question to the arm, and one
// to the board, takes beside ten pages, three of which take nothing in: lines as measure.mjs says them. The pages are in
// this machine's browser, once as it usually runs, and once so that it gives way to the cell at once (`remote`): as if
// the browsers were elsewhere. Who asks is a program of its own (asker.py), so that no browser's pace is measured.

import { execFile } from 'node:child_process';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { here, ownFolder, source, start } from '../../agents/console/browser.mjs';
import { p99, pause, say } from './figures.mjs';
import { idle, launchQuiet } from './quiet_browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const rounds = 8;
const questions = 200; // a round, of each kind

const folder = ownFolder();
const up = start([cell, 'up', join(source, 'examples/01-blocks/cell.scm'), '--console'], folder);

// Nothing moves any more once the person of the cell has taught its objects.
const first = await launchQuiet(scratch);
const live = () => document.body?.dataset.state === 'live';
const taught = await first.open(await up.next(1));
await taught.until(live);
await taught.evaluate(
  () =>
    new Promise((done) => {
      const socket = new WebSocket(`ws://${location.host}/socket`);
      socket.onmessage = ({ data }) => {
        const message = JSON.parse(data);
        if (message.hello) socket.send('(follow 1 (person done ?objects))');
        if (message.watch && message.added.length > 0) done();
      };
    }),
);
await first.close();

const near = await launchQuiet(scratch);
const address = await up.next(2);
const begun = Date.now();
const page = await near.open(address);
await page.until(
  () =>
    document.body?.dataset.state === 'live' &&
    /mm/.test(document.getElementById('readings').textContent) &&
    [...document.querySelectorAll('figure canvas')].every((canvas) => canvas.dataset.frame),
);
say('alive', Date.now() - begun);
const remote = await launchQuiet(scratch, idle);
const other = await up.next(3);
const pages = { near: page, remote: await remote.open(other) };
// They keep their sessions, and show nothing.
await page.show(new URL('/icon.svg', address).href);
await pages.remote.until(live);
await pages.remote.show(new URL('/icon.svg', other).href);

const gather = (where) =>
  pages[where].evaluate(
    (watchers, stalled) =>
      new Promise((done) => {
        window.sockets = [];
        let there = 0;
        for (let i = 0; i < watchers; ++i) {
          const takes = i >= stalled;
          const open = (path) => {
            const opened = new WebSocket(`ws://${location.host}${path}`);
            opened.binaryType = 'arraybuffer';
            window.sockets.push(opened);
            return opened;
          };
          const openLane = (path) => {
            const lane = open(path);
            lane.onmessage = () => takes && lane.send('(drawn 0)');
          };
          const socket = open('/socket');
          socket.onmessage = ({ data }) => {
            const message = JSON.parse(data);
            if (message.hello) {
              for (let lane = 0; lane < message.hello.images.lanes; ++lane) openLane(message.hello.images.path);
              for (const words of [
                '(look vision-colour)',
                '(look vision-annotated)',
                '(follow 1 (arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz))',
                '(follow 2 (look ?eyes ?frame ?text ?of))',
                '(follow 3 (place ?name ?x ?y ?z ?frame))',
              ])
                socket.send(words);
              if (++there === watchers) done();
            }
            if (message.pulse && takes) socket.send(`(stamp ${message.pulse})`);
            if ((message.watch || message.arm) && takes) socket.send('(heard 1)');
          };
        }
      }),
    10,
    3,
  );
const disperse = (where) => pages[where].evaluate(() => window.sockets.forEach((socket) => socket.close()));

// By turns, so that whatever else the machine does meets both.
const board = `ipc://${folder}/pizarra/blocks@localhost/board.ipc`;
const ask = () => promisify(execFile)('/usr/bin/python3', [join(here, '../../bench/console/asker.py'), source, board, questions]);
const took = { arm: {}, board: {} };
for (let round = 0; round < rounds; ++round) {
  for (const where of ['alone', ...Object.keys(pages)]) {
    if (where in pages) await gather(where);
    await pause(1500);
    const { stdout } = await ask();
    for (const [whom, times] of Object.entries(JSON.parse(stdout))) (took[whom][where] ??= []).push(...times);
    if (where in pages) await disperse(where);
  }
}
for (const [whom, { alone, ...beside }] of Object.entries(took)) {
  say(`${whom}-alone-p99`, p99(alone));
  for (const where of Object.keys(beside)) say(`${whom}-${where}-ratio`, p99(beside[where]) / p99(alone));
}
await Promise.all([near.close(), remote.close()]);
await up.end();
process.exit(0);
