// node broken_ways.mjs PIZARRA-CELL SCRATCH: the page's own connection, and those of its images, break off (RST), in
// mid-jog and right before STOP. The arm stands where nobody can hold it any more, and a STOP is told in any case.

import { expect, text } from './browser.mjs';
import { distance, jogs } from './driving.mjs';
import { lanesOnly, pageOnly } from './losing_line.mjs';
import { take, watchedDriver } from './watched_driver.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, witness, line, driving, onlooker, stops, standsNone, clear, moving, end } = await watchedDriver(cell, scratch);
const standing = () => onlooker.seen('arm\\s*(idle|stopped)');
const stopped = async (how) => {
  for (const each of [witness, page]) await each.waitForSelector('#stopped:not([hidden])');
  expect(/operator's STOP/.test(await text(witness, '#stopped-by')), `STOP stops, ${how}`);
  await page.waitForSelector('#stop-alarm', { state: 'hidden' });
};

// The page's own connection in mid-jog: the session ends, and the arm with it.
const broken = await moving();
expect(line.breakOff(pageOnly) === 1, 'the page’s own connection breaks off in mid-jog');
const at = await onlooker.place();
await standing();
await witness.waitForSelector('#arm-chip', { state: 'hidden' });
const stood = await onlooker.place();
expect(distance(at, stood) <= 15, `the arm stands, ${distance(at, stood).toFixed(0)} mm further, and is in nobody's hands`);
const { answer } = await driving.answered(broken);
expect(/console has gone/.test(answer), `the operator is told why: ${answer}`);
await page.waitForFunction(() => document.getElementById('hands-note').innerText.includes('You no longer have the arm in hand'));
await page.waitForSelector('body[data-state=live]');
expect(await page.isDisabled(jogs('left')), 'the page comes back without the arm, with the button still held down');
await page.mouse.up();
await take(page);
expect(distance(stood, await driving.standing()) <= 1, 'and nothing moved meanwhile');

// The connections of images in mid-jog: it goes on, and ends when it is let go.
let answered = '';
for (let attempt = 0; attempt < 30 && answered !== 'true'; ++attempt) {
  const command = await moving();
  const from = await onlooker.place();
  expect(line.breakOff(lanesOnly) > 1, 'the connections of images break off in mid-jog');
  await onlooker.goneOn(from, 5);
  await page.mouse.up();
  answered = (await driving.answered(command)).answer;
}
expect(answered === 'true', `the jog goes on by the page’s own connection, and ends when it is let go: ${answered}`);

// Right before STOP.
await driving.standing();
line.breakOff(lanesOnly);
await page.keyboard.press('Escape');
await stopped('whose images’ connections break off');
expect((await stops()).length === 1, 'it counts once');
await clear(page);
line.breakOff(pageOnly);
await page.keyboard.press('Escape');
await stopped('whose own connection breaks off');
await take(witness);
await clear(witness);
await page.waitForSelector('body[data-state=live]');

// While there is no line at all, and pressed twice: it is said to be unconfirmed at once, and told once there is one.
const before = (await stops()).length;
line.outOfOrder = true;
line.breakOff();
await page.waitForSelector('body[data-state=lost]');
await page.keyboard.press('Escape');
await page.waitForSelector('#stop-alarm[role=alert]:not([hidden])');
expect(/STOP is not confirmed.*not connected/.test(await text(page, '#stop-alarm')), 'without a line the page says that STOP is none yet');
await page.click('#stop');
line.outOfOrder = false;
await stopped('once the line is back, and the alarm ends');
await clear(witness);
expect((await standsNone()) && (await stops()).length === before + 1, 'it was pressed twice, and is told once');

await end();
