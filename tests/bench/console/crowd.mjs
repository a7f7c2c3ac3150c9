// node crowd.mjs SCRATCH FOLDER: how soon a page of the demo cell is alive, and what a question to the arm, and one to the
// board, takes beside ten watchers, three of which take nothing in: lines as measure.mjs says them. Who asks and who
// watches are pages of their own that show nothing, so that no browser's drawing is measured.

import { join } from 'node:path';
import { launch, openPage } from '../../agents/console/browser.mjs';
import { addressOf, p99, pause, say } from './figures.mjs';

const [scratch, folder] = process.argv.slice(2);
const rounds = 4;
const questions = 150; // a round

const browser = await launch(scratch);
const first = await addressOf(join(folder, 'addresses'), 1);
const begun = Date.now();
const page = await openPage(browser, first);
await page.waitForFunction(
  () =>
    document.body.dataset.state === 'live' &&
    /mm/.test(document.getElementById('readings').textContent) &&
    [...document.querySelectorAll('figure canvas')].every((canvas) => canvas.dataset.frame) &&
    document.querySelector('#story .timeline details'),
  null,
  { timeout: 60_000, polling: 'raf' },
);
say('alive', Date.now() - begun);
await page.close();

// A page with a session that shows nothing.
async function blank(n) {
  const address = await addressOf(join(folder, 'addresses'), n);
  const one = await openPage(await browser.newContext(), address);
  await one.waitForSelector('body[data-state=live]');
  await one.goto(new URL('/icon.svg', address).href);
  return one;
}
const asker = await blank(2);
const crowd = await blank(3);

const gather = () =>
  crowd.evaluate(
    ([watchers, stalled]) =>
      new Promise((done) => {
        window.sockets = [];
        let there = 0;
        for (let i = 0; i < watchers; ++i) {
          const socket = new WebSocket(`ws://${location.host}/socket`);
          socket.binaryType = 'arraybuffer';
          window.sockets.push(socket);
          socket.onmessage = ({ data }) => {
            const takes = i >= stalled;
            if (typeof data !== 'string') {
              const name = new TextDecoder().decode(new Uint8Array(data, 0, 60)).split(' ')[1];
              return takes && socket.send(`(drawn ${name})`);
            }
            const message = JSON.parse(data);
            if (message.hello) {
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
const disperse = () => crowd.evaluate(() => window.sockets.forEach((socket) => socket.close()));

const asked = (whom) =>
  asker.evaluate(
    ([of, count]) =>
      new Promise((done) => {
        const socket = new WebSocket(`ws://${location.host}/socket`);
        const took = [];
        let sent = 0;
        const ask = () => {
          sent = performance.now();
          const number = took.length + 1;
          socket.send(of === 'arm' ? `(request ${number} robot (get-status))` : `(watch ${number} "(agent ?name ?kind ?host)")`);
        };
        socket.onmessage = ({ data }) => {
          const message = JSON.parse(data);
          if (message.hello) ask();
          if (message.pulse) socket.send(`(stamp ${message.pulse})`);
          if (message.arm) socket.send('(heard 1)');
          if (message.watch) {
            socket.send('(heard 1)');
            socket.send(`(unwatch ${message.watch})`);
          }
          if ((message.reply ?? message.watch) !== took.length + 1) return;
          took.push(performance.now() - sent);
          if (took.length < count) return setTimeout(ask, 10);
          socket.close();
          done(took);
        };
      }),
    [whom, questions],
  );

// By turns, so that whatever else the machine does meets both.
const took = { arm: { alone: [], among: [] }, board: { alone: [], among: [] } };
for (let round = 0; round < rounds; ++round) {
  for (const how of ['alone', 'among']) {
    if (how === 'among') await gather();
    await pause(1500);
    for (const whom of ['arm', 'board']) took[whom][how].push(...(await asked(whom)));
    if (how === 'among') await disperse();
  }
}
for (const [whom, { alone, among }] of Object.entries(took)) {
  say(`${whom}-alone-p99`, p99(alone));
  say(`${whom}-crowd-ratio`, p99(among) / p99(alone));
}
await browser.close();
process.exit(0);
