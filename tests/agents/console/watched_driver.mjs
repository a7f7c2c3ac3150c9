// A page that drives the arm over a line that can fail, and a witness who comes by another line: what the tests of the
// page's two ways stand on.
//
//   const { page, witness, line, moving, ... } = await watchedDriver(cell, scratch);
//   await moving();                                   the arm moves for a button of the page that is held down
//   line.lose(pageOnly); line.restore();              losing_line.mjs

import { join } from 'node:path';
import { ask, expect, here, launch, openPage, ownFolder, start, text } from './browser.mjs';
import { Driving, jogs, Onlooker } from './driving.mjs';
import { losingLine } from './losing_line.mjs';

// The page's connections stay in window.sockets, with what was said on each.
const keepSockets = () => {
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
};

// Every stop that is told stays in window.stops.
const keepStops = () => {
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
};

export async function take(who) {
  await who.click('#take-arm');
  await who.waitForFunction(() => document.getElementById('arm-chip').textContent.includes('your hands'));
}

export async function watchedDriver(cell, scratch) {
  const served = start([cell, 'console', join(here, 'unattended.scm')], ownFolder());
  const address = await served.line;
  const { port } = new URL(address);
  const line = await losingLine(Number(port));
  const browser = await launch(scratch, [`--host-resolver-rules=MAP 127.0.0.1:${port} 127.0.0.1:${line.port}`]);
  const context = await browser.newContext();
  await context.addInitScript(keepSockets);
  const page = await openPage(context, address);
  await page.waitForSelector('body[data-state=live]');
  const driving = new Driving(page);
  await driving.begin();
  expect((await driving.driven('Ready', '(ready)')) === 'true', 'READY');

  const direct = await launch(scratch);
  const witness = await openPage(direct, await served.next(1));
  await witness.waitForSelector('body[data-state=live]');
  await witness.click('#tab-drive');
  await witness.evaluate(keepStops);
  const stops = () => witness.evaluate(() => window.stops);
  const clear = async (who) => {
    await who.click('#clear-stops');
    await who.click('#confirm button[value=yes]');
    await witness.waitForSelector('#stopped', { state: 'hidden' });
  };

  // Whether no stop stands, once all is told that the page's own connection has brought.
  const standsNone = async () => {
    await driving.press('Monitor');
    await driving.answered('(monitor)');
    await ask(witness, '(stop ?who ?reason)');
    await witness.waitForFunction(() => /answer/.test(document.getElementById('query-count').textContent));
    const count = await text(witness, '#query-count');
    await witness.click('#tab-drive');
    return count === '0 answers';
  };

  // A machine that is busy elsewhere may be too late by itself: then once more, to and fro. Answers the command.
  let way = 'left';
  async function moving() {
    for (let attempt = 0; attempt < 30; ++attempt) {
      way = way === 'left' ? 'right' : 'left';
      const command = `(jog ${way})`;
      await page.hover(jogs(way));
      await page.mouse.down();
      await page.waitForFunction(
        (told) => window.newest(told).answer || /arm\s*moving\s*\(jog/.test(document.getElementById('readings').innerText),
        command,
      );
      if (await page.evaluate((told) => window.newest(told).answer === null, command)) return command;
      await page.mouse.up();
    }
    throw new Error('the page was never quick enough to jog');
  }

  async function end() {
    for (const each of [page, witness]) expect(each.troubles.length === 0, `nothing went wrong: ${each.troubles.join('; ')}`);
    line.end();
    for (const each of [browser, direct]) await each.close();
    expect((await served.end()) === 0, 'it ends in order');
    process.exit(0);
  }
  return { page, witness, line, driving, onlooker: new Onlooker(witness), stops, standsNone, clear, moving, end };
}
