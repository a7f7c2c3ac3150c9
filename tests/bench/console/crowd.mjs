// node crowd.mjs PIZARRA-CELL SCRATCH: how soon a page of a running cell is alive, and what a question to the arm, and one
// to the board, takes beside ten pages, three of which take nothing in: lines as measure.mjs says them. Who asks is a
// program of its own (asker.py), so that no browser's pace is measured.

import { execFile } from 'node:child_process';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { here, launch, openPage, ownFolder, source, start, taught } from '../../agents/console/browser.mjs';
import { p99, pause, say } from './figures.mjs';

const [cell, scratch] = process.argv.slice(2);
const rounds = 5;
const questions = 200; // a round, of each kind

const folder = ownFolder();
const described = join(source, 'examples/01-blocks/cell.scm');
const up = start([cell, 'up', described, '--console'], folder);
const before = await launch(scratch);
await taught(await openPage(before, await up.next(1)));
await before.close();

const browser = await launch(scratch);
const address = await up.next(2);
const begun = Date.now();
const page = await openPage(browser, address);
await page.waitForFunction(
  () =>
    document.body.dataset.state === 'live' &&
    /mm/.test(document.getElementById('readings').textContent) &&
    [...document.querySelectorAll('figure canvas')].every((canvas) => canvas.dataset.frame),
  null,
  { timeout: 60_000, polling: 'raf' },
);
say('alive', Date.now() - begun);
// It keeps its session, and shows nothing.
await page.goto(new URL('/icon.svg', address).href);

const gather = () =>
  page.evaluate(
    ([watchers, stalled]) =>
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
    [10, 3],
  );
const disperse = () => page.evaluate(() => window.sockets.forEach((socket) => socket.close()));

// By turns, so that whatever else the machine does meets both.
const board = `ipc://${folder}/pizarra/blocks@localhost/board.ipc`;
const ask = () => promisify(execFile)('/usr/bin/python3', [join(here, '../../bench/console/asker.py'), source, board, questions]);
const took = { arm: { alone: [], among: [] }, board: { alone: [], among: [] } };
for (let round = 0; round < rounds; ++round) {
  for (const how of ['alone', 'among']) {
    if (how === 'among') await gather();
    await pause(1500);
    const { stdout } = await ask();
    for (const [whom, times] of Object.entries(JSON.parse(stdout))) took[whom][how].push(...times);
    if (how === 'among') await disperse();
  }
}
for (const [whom, { alone, among }] of Object.entries(took)) {
  say(`${whom}-alone-p99`, p99(alone));
  say(`${whom}-crowd-ratio`, p99(among) / p99(alone));
}
await browser.close();
await up.end();
process.exit(0);
