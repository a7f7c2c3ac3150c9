// node measure.mjs SCRATCH ADDRESSES JOG-SECONDS [--crowd]: what an operator's browser takes of a console whose addresses
// come into the file ADDRESSES: a line `NAME VALUE` a figure, milliseconds where it says no other.

import { existsSync, readFileSync } from 'node:fs';
import { launch, openPage } from '../../agents/console/browser.mjs';

const [scratch, addresses, jogSeconds, ...options] = process.argv.slice(2);
const say = (name, value) => console.log(`${name} ${value}`);
const mean = (values) => values.reduce((a, b) => a + b, 0) / values.length;
const p99 = (values) => values.toSorted((a, b) => a - b)[Math.min(values.length - 1, Math.floor(values.length * 0.99))];
const pause = (ms) => new Promise((later) => setTimeout(later, ms));

// The n-th that the console said, as soon as it has.
async function addressOf(n) {
  while (true) {
    const lines = existsSync(addresses) ? readFileSync(addresses, 'utf8').split('\n') : [];
    if (lines.length > n) return lines[n - 1];
    await pause(50);
  }
}

const browser = await launch(scratch);
const address = await addressOf(1);
const begun = Date.now();
const page = await openPage(browser, address);
const alive = (one) =>
  one.waitForFunction(
    () =>
      document.body.dataset.state === 'live' &&
      /mm/.test(document.getElementById('readings').textContent) &&
      document.querySelector('figure canvas')?.dataset.frame,
    null,
    { timeout: 60_000, polling: 'raf' },
  );
await alive(page);
say('alive', Date.now() - begun);

// Until every object is taught the arm is the person's.
await page.click('#tab-facts');
await page.fill('#query', '(person done ?objects)');
await page.press('#query', 'Enter');
await page.waitForFunction(() => document.getElementById('query-count').textContent === '1 answer', null, {
  timeout: 180_000,
});

// Images: when each was drawn, and how old it was then.
const images = (seconds) =>
  page.evaluate(
    (ms) =>
      new Promise((done) => {
        const canvas = document.querySelector('figure canvas');
        const seen = [];
        const watcher = new MutationObserver(() =>
          seen.push([performance.now(), Date.now() - Number(canvas.dataset.captured) / 1000]),
        );
        watcher.observe(canvas, { attributes: true, attributeFilter: ['data-frame'] });
        setTimeout(() => {
          watcher.disconnect();
          done(seen);
        }, ms);
      }),
    seconds * 1000,
  );
const intervals = (seen) => seen.slice(1).map(([at], i) => at - seen[i][0]);
const hideScene = (hidden) => page.evaluate((to) => (document.getElementById('scene-card').hidden = to), hidden);
const watched = await images(20);
say('interval-mean', mean(intervals(watched)));
say('interval-p99', p99(intervals(watched)));
say('photon-shown-p99', p99(watched.map(([, age]) => age)));
await hideScene(true);
say('photon-hidden-p99', p99((await images(15)).map(([, age]) => age)));
await hideScene(false);

// A socket of the bench's own, in the page: what the arm did, by the board's clock, which is this machine's.
await page.evaluate(() => {
  window.arm = [];
  const socket = new WebSocket(`ws://${location.host}/socket`);
  socket.onmessage = ({ data }) => {
    if (typeof data !== 'string') return;
    const message = JSON.parse(data);
    if (message.hello) socket.send('(follow 1 (arm ?robot ?state ?action))');
    if (message.pulse) socket.send(`(stamp ${message.pulse})`);
    for (const { facts } of message.watch === 1 ? message.added : []) window.arm.push(facts[0]);
    if (message.watch) socket.send('(heard 1)');
  };
});
await page.click('#tab-drive');
await page.click('#take-arm');
await page.waitForSelector('.jog:not(:disabled)');
await pause(1500);
const press = (direction, ms) =>
  page.evaluate(
    async ([way, length]) => {
      const button = document.querySelector(`.jog[data-jog=${way}]`);
      const log = document.querySelector('#drive .log');
      const before = window.arm.length;
      const pressed = Date.now();
      button.dispatchEvent(new PointerEvent('pointerdown', { button: 0, pointerId: 1 }));
      const item = log.firstChild;
      const released = new Promise((later) => setTimeout(later, length));
      await released;
      button.dispatchEvent(new PointerEvent('pointerup', { pointerId: 1 }));
      while (item.textContent.endsWith('…')) await new Promise((later) => setTimeout(later, 10));
      const moved = window.arm.slice(before).find((fact) => / moving /.test(fact.text));
      return { said: item.textContent, motion: moved ? moved.when / 1000 - pressed : null };
    },
    [direction, ms],
  );
const silent = ({ said }) => /has not renewed|late/.test(said);
const clicks = [];
for (let i = 0; i < 40; ++i) {
  const { motion } = await press(i % 2 ? 'left' : 'right', 300);
  if (motion !== null) clicks.push(motion);
}
if (clicks.length > 20) say('click-to-motion-p99', p99(clicks));

let stops = 0;
let held = 0;
for (let i = 0; held < Number(jogSeconds); ++i) {
  const began = Date.now();
  if (silent(await press(i % 2 ? 'left' : 'right', 5000))) ++stops;
  held += (Date.now() - began) / 1000;
}
say('false-stops', stops);
say('jogged-s', held);

// A page that falls silent in mid-jog, seen by another one.
const other = await browser.newContext();
const witness = await openPage(other, await addressOf(2));
await alive(witness);
await witness.evaluate(() => {
  window.seen = [];
  const socket = new WebSocket(`ws://${location.host}/socket`);
  socket.onmessage = ({ data }) => {
    if (typeof data !== 'string') return;
    const message = JSON.parse(data);
    if (message.hello) socket.send('(follow 1 (arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz))');
    if (message.hello) socket.send('(follow 2 (arm ?robot ?state ?action))');
    if (message.pulse) socket.send(`(stamp ${message.pulse})`);
    if (!message.watch) return;
    for (const { facts } of message.added) window.seen.push(facts[0]);
    socket.send('(heard 1)');
  };
});
const distances = [];
const delays = [];
for (let i = 0; i < 5; ++i) {
  await page.bringToFront();
  const silence = await page.evaluate(async (way) => {
    const button = document.querySelector(`.jog[data-jog=${way}]`);
    button.dispatchEvent(new PointerEvent('pointerdown', { button: 0, pointerId: 1 }));
    await new Promise((later) => setTimeout(later, 1500));
    const deadline = Number(document.getElementById('jog-note').textContent.match(/silence of (\d+)/)?.[1] ?? 600);
    const at = Date.now();
    while (Date.now() < at + 1500);
    button.dispatchEvent(new PointerEvent('pointerup', { pointerId: 1 }));
    return { at, deadline };
  }, i % 2 ? 'left' : 'right');
  await pause(1500);
  const seen = await witness.evaluate(() => window.seen.splice(0));
  const poses = seen.filter(({ text }) => text.startsWith('(arm-pose '));
  const stood = seen.find(({ text, when }) => / stopped /.test(text) && when / 1000 > silence.at);
  const place = ({ text }) => text.slice(10).split(' ').slice(1, 4).map(Number);
  const before = poses.filter(({ when }) => when / 1000 <= silence.at).at(-1);
  if (!stood || !before) continue;
  const [a, b] = [place(before), place(poses.at(-1))];
  distances.push(Math.hypot(...a.map((value, axis) => value - b[axis])));
  delays.push(stood.when / 1000 - silence.at - silence.deadline);
}
if (distances.length > 0) {
  say('stop-distance-max', Math.max(...distances));
  say('stop-after-deadline-max', Math.max(...delays));
}

// Ten watchers, three of which take nothing in, and what a question to the arm, and one to the board, takes meanwhile.
if (options.includes('--crowd')) {
  const asked = (whom, crowd) =>
    page.evaluate(
      ([whom, [watchers, stalled]]) =>
        new Promise((done) => {
          const sockets = [];
          for (let i = 0; i < watchers; ++i) {
            const socket = new WebSocket(`ws://${location.host}/socket`);
            socket.binaryType = 'arraybuffer';
            sockets.push(socket);
            socket.onmessage = ({ data }) => {
              const takes = i >= stalled;
              if (typeof data !== 'string') {
                const name = new TextDecoder().decode(new Uint8Array(data, 0, 60)).split(' ')[1];
                return takes && socket.send(`(drawn ${name})`);
              }
              const message = JSON.parse(data);
              if (message.hello) {
                for (const say of [
                  '(look vision-colour)',
                  '(look vision-annotated)',
                  '(follow 1 (arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz))',
                  '(follow 2 (look ?eyes ?frame ?text ?of))',
                  '(follow 3 (place ?name ?x ?y ?z ?frame))',
                ])
                  socket.send(say);
              }
              if (message.pulse && takes) socket.send(`(stamp ${message.pulse})`);
              if ((message.watch || message.arm) && takes) socket.send('(heard 1)');
            };
          }
          const socket = new WebSocket(`ws://${location.host}/socket`);
          const took = [];
          let sent = 0;
          const ask = () => {
            sent = performance.now();
            const number = took.length + 1;
            socket.send(whom === 'arm' ? `(request ${number} robot (get-status))` : `(watch ${number} "(agent ?name ?kind ?host)")`);
          };
          socket.onmessage = ({ data }) => {
            const message = JSON.parse(data);
            if (message.hello) setTimeout(ask, 2000);
            if (message.pulse) socket.send(`(stamp ${message.pulse})`);
            if (message.arm) socket.send('(heard 1)');
            if (message.watch) {
              socket.send('(heard 1)');
              socket.send(`(unwatch ${message.watch})`);
            }
            if ((message.reply ?? message.watch) !== took.length + 1) return;
            took.push(performance.now() - sent);
            if (took.length < 300) return setTimeout(ask, 10);
            for (const each of [...sockets, socket]) each.close();
            done(took);
          };
        }),
      [whom, crowd],
    );
  for (const whom of ['arm', 'board']) {
    const alone = p99(await asked(whom, [0, 0]));
    await pause(1500);
    const among = p99(await asked(whom, [10, 3]));
    await pause(1500);
    say(`${whom}-alone-p99`, alone);
    say(`${whom}-crowd-ratio`, among / alone);
  }
}
await browser.close();
process.exit(0);
