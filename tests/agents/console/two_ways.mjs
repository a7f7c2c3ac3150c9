// node two_ways.mjs PIZARRA-CELL SCRATCH: what moves the arm and stops it is said on two connections, the page's own and an
// image's. Each of them falls silent in turn, in mid-jog and before STOP: the arm stops, and what comes late on the
// connection that was silent counts no second time.

import { expect, text } from './browser.mjs';
import { distance } from './driving.mjs';
import { lanesOnly, pageOnly } from './losing_line.mjs';
import { take, watchedDriver } from './watched_driver.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, witness, line, driving, onlooker, stops, standsNone, clear, moving, end } = await watchedDriver(cell, scratch);

// The page's own connection falls silent in mid-jog. Holds go on coming by the other, with stamps that get old.
const silenced = await moving();
expect(line.lose(pageOnly) === 1, 'the page’s own connection falls silent');
const at = await onlooker.place();
await onlooker.seen('arm\\s*stopped');
const stood = await onlooker.place();
expect(distance(at, stood) <= 15, `the arm stands by itself, ${distance(at, stood).toFixed(0)} mm further`);
line.restore();
const { answer } = await driving.answered(silenced);
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
expect((await standsNone()) && (await stops()).length === 1, 'it counts once: late, it stops nothing anew');
await witness.click('#take-arm');
await page.waitForSelector('#arm-chip', { state: 'hidden' });
await take(page);

// The connections of images fall silent before a jog: it goes on, and ends when it is let go.
let answered = '';
for (let attempt = 0; attempt < 30 && answered !== 'true'; ++attempt) {
  expect(line.lose(lanesOnly) > 1, 'the connections of images fall silent');
  const command = await moving();
  const from = await onlooker.place();
  await onlooker.goneOn(from, 5);
  await page.mouse.up();
  answered = (await driving.answered(command)).answer;
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
await witness.waitForFunction(() => window.stops.some((one) => /said behind it/.test(one)));
const told = await stops();
expect(told.length === 3 && /said behind it/.test(told[2]), `each STOP counts once: ${told.join(', ')}`);
await driving.press('Monitor');
await driving.answered('(monitor)');
expect(distance(before, await onlooker.place()) <= 1, 'and a jog that comes late moves nothing');

await end();
