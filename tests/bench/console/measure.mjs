// node measure.mjs FOLDER JOG-SECONDS [--cut]: what an operator's browser takes of a console whose addresses come into
// FOLDER/addresses, and whose eyes have the camera of pictures.mjs: a line `NAME VALUE` a figure, milliseconds where it
// says no other. With --cut the line is lost in mid-jog, when a line says `cut`, until one says `whole`; else the page
// falls silent.

import { writeSync } from 'node:fs';
import { join } from 'node:path';
import { read } from './coded.mjs';
import { addressOf, mean, p99, pause, say } from './figures.mjs';
import { launchQuiet } from './quiet_browser.mjs';

const [folder, jogSeconds, ...options] = process.argv.slice(2);
const addresses = join(folder, 'addresses');

const browser = await launchQuiet(folder);
const page = await browser.open(await addressOf(addresses, 1));
const alive = (one) =>
  one.until(() => document.body?.dataset.state === 'live' && /mm/.test(document.getElementById('readings').textContent));
await alive(page);
await page.click('#tab-eyes');
await page.click('#eyes button', 'Connect');
await page.until(() => document.querySelector('figure canvas').dataset.frame);

// In the animation frame that draws a picture its number is read back from the pixels: when each was seen first, and how
// long after its stamp.
const images = (seconds) =>
  page.evaluate(
    (ms, reading) =>
      new Promise((done) => {
        const numberIn = new Function(`return ${reading}`)();
        const canvas = document.querySelector('figure canvas');
        const seen = [];
        const look = () => {
          const number = numberIn(canvas);
          const at = Date.now();
          if (number === null || number === seen.at(-1)?.number) return;
          seen.push({ number, at, age: at - Number(canvas.dataset.captured) / 1000 });
        };
        const drawn = new MutationObserver(look);
        drawn.observe(canvas, { attributes: true, attributeFilter: ['data-frame'] });
        setTimeout(() => {
          drawn.disconnect();
          done(seen);
        }, ms);
      }),
    seconds * 1000,
    read.toString(),
  );
const intervals = (seen) => seen.slice(1).map(({ at }, i) => at - seen[i].at);
const ages = (seen) => seen.map(({ age }) => age);
const hideScene = (hidden) => page.evaluate((to) => void (document.getElementById('scene-card').hidden = to), hidden);
const watched = await images(20);
say('interval-mean', mean(intervals(watched)));
say('interval-p99', p99(intervals(watched)));
say('photon-shown-p99', p99(ages(watched)));
await hideScene(true);
say('photon-hidden-p99', p99(ages(await images(20))));
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
await page.until(() => document.querySelector('.jog:not(:disabled)'));
await pause(1500);
const press = (direction, ms) =>
  page.evaluate(
    async (way, length) => {
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
    direction,
    ms,
  );
// A jog that ended although its button was held: its holds did not come, or came too late, or the line was lost.
const silent = ({ said }) => /has not renewed|too late|console has gone/.test(said);
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

// The arm when its page falls silent in mid-jog, seen by another one, which shows nothing, so that the first has the
// machine.
const shown = await addressOf(addresses, 2);
const witness = await browser.open(shown);
await alive(witness);
await witness.show(new URL('/icon.svg', shown).href);
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
const jogging = (way) =>
  page.evaluate(async (direction) => {
    window.held = document.querySelector(`.jog[data-jog=${direction}]`);
    window.held.dispatchEvent(new PointerEvent('pointerdown', { button: 0, pointerId: 1 }));
    await new Promise((later) => setTimeout(later, 1500));
  }, way);
const lettingGo = () => page.evaluate(() => window.held.dispatchEvent(new PointerEvent('pointerup', { pointerId: 1 })));
// Each answers when the silence began.
const busy = () =>
  page.evaluate(() => {
    const at = Date.now();
    while (Date.now() < at + 1500);
    return at;
  });
const withoutLine = async () => {
  const at = Date.now();
  writeSync(1, 'cut\n');
  await pause(1500);
  writeSync(1, 'whole\n');
  await pause(3000);
  return at;
};
const distances = [];
const delays = [];
for (let i = 0; i < 5; ++i) {
  await page.toFront();
  await jogging(i % 2 ? 'left' : 'right');
  const silentSince = await (options.includes('--cut') ? withoutLine() : busy());
  await lettingGo();
  await pause(1500);
  const seen = await witness.evaluate(() => window.seen.splice(0));
  const poses = seen.filter(({ text }) => text.startsWith('(arm-pose '));
  const stood = seen.find(({ text, when }) => / stopped /.test(text) && when / 1000 > silentSince);
  const place = ({ text }) => text.slice(10).split(' ').slice(1, 4).map(Number);
  const before = poses.filter(({ when }) => when / 1000 <= silentSince).at(-1);
  if (!stood || !before) throw new Error(`cut ${i + 1}: ${before ? 'the arm did not stop' : 'the arm did not move before'}`);
  const [a, b] = [place(before), place(poses.at(-1))];
  distances.push(Math.hypot(...a.map((value, axis) => value - b[axis])));
  const [, deadline] = stood.text.match(/\(jog \S+ ([\d.]+)\)/);
  delays.push(stood.when / 1000 - silentSince - Number(deadline));
}
if (distances.length > 0) {
  say('stop-distance-max', Math.max(...distances));
  say('stop-after-deadline-max', Math.max(...delays));
}

await browser.close();
process.exit(0);
