// node two_ways.mjs PIZARRA-CELL SCRATCH: what moves the arm and stops it is said on two connections, the page's own and an
// image's. Each of them falls silent in turn, in mid-jog and before STOP: the arm stops, and what comes late on the
// connection that was silent counts no second time.

import { join } from 'node:path';
import { expect, here, launch, openPage, ownFolder, start, text } from './browser.mjs';
import { distance, Driving, jogs, Onlooker } from './driving.mjs';
import { lanesOnly, losingLine, pageOnly } from './losing_line.mjs';

const [cell, scratch] = process.argv.slice(2);
const folder = ownFolder();
const served = start([cell, 'console', join(here, 'unattended.scm')], folder);
const address = await served.line;
const { port } = new URL(address);
const line = await losingLine(Number(port));
const browser = await launch(scratch, [`--host-resolver-rules=MAP 127.0.0.1:${port} 127.0.0.1:${line.port}`]);
const context = await browser.newContext();
// The page's connections, and what went on each.
await context.addInitScript(() => {
  window.sockets = [];
  window.WebSocket = class extends WebSocket {
    said = [];
    constructor(address) {
      super(address);
      window.sockets.push(this);
    }
    send(message) {
      this.said.push(message);
      super.send(message);
    }
  };
});
const page = await openPage(context, address);
await page.waitForSelector('body[data-state=live]');
const driving = new Driving(page);
await driving.begin();
expect((await driving.driven('Ready', '(ready)')) === 'true', 'READY');

// Somebody who comes by another line: how the arm stands, and every stop that is told.
const direct = await launch(scratch);
const witness = await openPage(direct, await served.next(1));
await witness.waitForSelector('body[data-state=live]');
await witness.click('#tab-drive');
await witness.evaluate(() => {
  window.stops = [];
  const socket = new WebSocket(`ws://${location.host}/socket`);
  socket.onmessage = ({ data }) => {
    const message = JSON.parse(data);
    if (message.hello) socket.send('(follow 1 (stop ?who ?reason))');
    if (message.pulse) socket.send(`(stamp ${message.pulse})`);
    if (!message.watch) return;
    for (const { facts } of message.added) window.stops.push(facts[0].text);
    socket.send('(heard 1)');
  };
});
const stops = () => witness.evaluate(() => window.stops);
const onlooker = new Onlooker(witness);
const take = async (who) => {
  await who.click('#take-arm');
  await who.waitForFunction(() => document.getElementById('arm-chip').textContent.includes('your hands'));
};
const clear = async (who) => {
  await who.click('#clear-stops');
  await who.click('#confirm button[value=yes]');
  await witness.waitForSelector('#stopped', { state: 'hidden' });
};

// A machine that is busy elsewhere may be too late by itself: then once more, to and fro.
let way = 'left';
const command = () => `(jog ${way})`;
async function moving() {
  for (let attempt = 0; attempt < 30; ++attempt) {
    way = way === 'left' ? 'right' : 'left';
    await page.hover(jogs(way));
    await page.mouse.down();
    await page.waitForFunction(
      (told) => window.newest(told).answer || /arm\s*moving\s*\(jog/.test(document.getElementById('readings').innerText),
      command(),
    );
    if (await page.evaluate((told) => window.newest(told).answer === null, command())) return;
    await page.mouse.up();
  }
  throw new Error('the page was never quick enough to jog');
}

// The page's own connection falls silent in mid-jog. Holds go on coming by the other, with stamps that get old.
await moving();
expect(line.lose(pageOnly) === 1, 'the page’s own connection falls silent');
const at = await onlooker.place();
await onlooker.seen('arm\\s*stopped');
const stood = await onlooker.place();
expect(distance(at, stood) <= 15, `the arm stands by itself, ${distance(at, stood).toFixed(0)} mm further`);
line.restore();
const { answer } = await driving.answered(command());
expect(/has not renewed its hold/.test(answer), `the operator is told why: ${answer}`);
await page.mouse.up();
await driving.standing();
expect(distance(stood, await onlooker.place()) <= 1, 'and what comes late moves nothing');

// Before STOP: that goes by an image's connection.
expect(line.lose(pageOnly) === 1, 'the page’s own connection falls silent again');
await page.keyboard.press('Escape');
await witness.waitForSelector('#stopped:not([hidden])');
expect(/operator's STOP/.test(await text(witness, '#stopped-by')), 'STOP stops, by an image’s connection');
await witness.click('#take-arm');
await witness.click('#confirm button[value=yes]');
await witness.waitForFunction(() => document.getElementById('arm-chip').textContent.includes('your hands'));
await clear(witness);
line.restore();
await page.waitForSelector('body[data-state=live]');
// A question on the connection on which the STOP comes late; its answer comes after it.
await driving.press('Monitor');
await driving.answered('(monitor)');
expect((await stops()).length === 1 && (await witness.isHidden('#stopped')), 'it counts once: late, it stops nothing anew');
await witness.click('#take-arm');
await page.waitForSelector('#arm-chip', { state: 'hidden' });
await take(page);

// The connections of images fall silent before a jog: it goes on, and ends when it is let go.
let answered = '';
for (let attempt = 0; attempt < 30 && answered !== 'true'; ++attempt) {
  expect(line.lose(lanesOnly) > 1, 'the connections of images fall silent');
  await moving();
  const from = await onlooker.place();
  await witness.waitForFunction(
    ([x, y]) => {
      const shown = document.getElementById('readings').innerText;
      const [nowX, nowY] = shown.match(/grip\s*([-\d]+)\s+([-\d]+)/).slice(1).map(Number);
      return Math.hypot(nowX - x, nowY - y) >= 5 || !/arm\s*moving/.test(shown);
    },
    from,
  );
  await page.mouse.up();
  answered = (await driving.answered(command())).answer;
  line.restore();
}
expect(answered === 'true', `a jog goes on by the page’s own connection, and ends when it is let go: ${answered}`);

// And before STOP, which goes by the page's own.
const before = await driving.standing();
expect(line.lose(lanesOnly) > 1, 'the connections of images fall silent');
await page.keyboard.press('Escape');
await witness.waitForSelector('#stopped:not([hidden])');
await page.waitForFunction(() => document.getElementById('stop-note').textContent === 'STOP is told');
await clear(page);
line.restore();
// Another is said on that connection behind it: what that one brings late has been heard before.
await page.evaluate(() => {
  const lane = window.sockets.find(({ url, said, readyState }) => /socket.\d+$/.test(url) && readyState === 1 && said.some((one) => one.startsWith('(stop ')));
  lane.send('(stop 1000000 "said behind it")');
});
await witness.waitForFunction(() => /said behind it/.test(document.getElementById('stopped-by').textContent));
const told = await stops();
expect(told.length === 3 && /said behind it/.test(told[2]), `each STOP counts once: ${told.join(', ')}`);
await driving.press('Monitor');
await driving.answered('(monitor)');
expect(distance(before, await onlooker.place()) <= 1, 'and a jog that comes late moves nothing');

for (const each of [page, witness]) expect(each.troubles.length === 0, `nothing went wrong: ${each.troubles.join('; ')}`);
line.end();
for (const each of [browser, direct]) await each.close();
expect((await served.end()) === 0, 'it ends in order');
process.exit(0);
