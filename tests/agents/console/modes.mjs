// node modes.mjs PIZARRA-CELL SCRATCH: the eyes' modes, for two pages at once: CONNECT and DISCONNECT, what excludes what
// and why a button is off, FIND's cross, TRACK of several objects and END TRACK.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, launch, openPage, ownFolder, start, taught, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const served = start([cell, 'console'], folder);
const page = await openPage(browser, await served.line);
await page.waitForSelector('body[data-state=live]');
const other = await browser.newContext();
const second = await openPage(other, await served.next(1));
await second.waitForSelector('body[data-state=live]');
await taught(page);
for (const each of [page, second]) await each.click('#tab-eyes');
await page.waitForFunction(() => document.querySelectorAll('.objects li').length === 5);
const names = await page.locator('.objects li strong').allInnerTexts();
expect(names[0] === 'end-effector', `the end-effector comes first: ${names}`);
expect((await page.locator('.objects .templates canvas').count()) >= 5, 'every object has its picture');

const button = (of, label) => of.locator(`#eyes button:text-is("${label}")`);
const isOff = (of, label) => of.waitForSelector(`#eyes button:text-is("${label}"):disabled`);
const isOn = (of, label) => of.waitForSelector(`#eyes button:text-is("${label}"):not(:disabled)`);
const why = (of, label) => button(of, label).getAttribute('title');
const row = (of, name, label) => of.locator(`.objects li:has(strong:text-is("${name}")) button:text-is("${label}")`);
const says = (of, words) =>
  of.waitForFunction((said) => document.getElementById('eyes').innerText.includes(said), words);

await isOff(page, 'Disconnect');
expect((await why(page, 'Disconnect')) === 'you are not connected', 'DISCONNECT is off, and says why');
await button(page, 'Connect').click();
await isOn(page, 'Disconnect');
await isOff(page, 'Connect');
await says(second, ': connected');
expect(!(await button(second, 'Connect').isDisabled()), 'another page connects for itself');
await button(page, 'Disconnect').click();
await isOn(page, 'Connect');
await isOff(page, 'Disconnect');
expect(true, 'CONNECT and DISCONNECT');

// FIND: the answer has the thesis' words, and the picture of the dark mark a bright cross there.
await row(page, 'cross', 'Find').click();
await page.waitForFunction(() => /^\(FIND "cross" OK/.test(document.getElementById('eyes-answer').textContent));
const [x, y] = (await text(page, '#eyes-answer')).match(/\(([\d.]+), ([\d.]+)\)/).slice(1).map(Number);
await page.waitForFunction(
  ([cx, cy]) => {
    const canvas = document.querySelectorAll('figure canvas')[1];
    const scale = canvas.width / 320;
    const [x, y] = [Math.round((cx + 0.5) * scale) - 1, Math.round((cy + 0.5) * scale) - 1];
    const brightest = (dx, dy) => Math.max(...canvas.getContext('2d').getImageData(x + dx, y + dy, 2, 2).data.filter((_, i) => i % 4 < 3));
    return [[0, 0], [-6, 0], [6, 0], [0, -6], [0, 6]].every(([dx, dy]) => brightest(dx, dy) > 130);
  },
  [x, y],
);
expect(true, 'FIND draws a cross');

for (const name of ['end-effector', 'circle', 'square']) {
  await row(page, name, 'Track').click();
  await page.waitForFunction(
    (tracked) => document.querySelector('[aria-label="What TRACK says"]').textContent.includes(`("${tracked}"`),
    name,
  );
}
const track = await text(page, '[aria-label="What TRACK says"]');
expect(/^\(TRACK 3 \("end-effector" /.test(track), `TRACK names the end-effector first: ${track}`);
await page.waitForFunction(() =>
  /\("circle" OK \([\d.]+, [\d.]+, [\d.]+\)\)/.test(document.querySelector('[aria-label="What TRACK says"]').textContent),
);
expect(true, 'with x, y and d of what is seen');
await page.screenshot({ path: join(pictures, 'tracking-several.png') });
for (const [of, what] of [[page, 'own'], [second, 'another page’s']]) {
  await of.waitForSelector('#training:disabled');
  expect(/tracks, which excludes learning/.test(await of.getAttribute('#training', 'title')), `${what} tracking excludes learning`);
  expect(/tracks, which excludes learning/.test(await row(of, 'cross', 'Forget').getAttribute('title')), 'and forgetting');
}
await isOff(second, 'End track');
expect(/tracks, and ends it itself/.test(await why(second, 'End track')), 'another’s tracking is not ended here');
await row(page, 'cross', 'Find').click();
await page.waitForFunction(() => /^\(FIND "cross" OK/.test(document.getElementById('eyes-answer').textContent));
expect(true, 'what is tracked does not keep FIND from its answer');
await button(page, 'End track').click();
await page.waitForSelector('[aria-label="What TRACK says"]', { state: 'hidden' });
for (const each of [page, second]) await each.waitForSelector('#training:not(:disabled)');
await isOff(page, 'End track');
expect((await why(page, 'End track')) === 'nothing is tracked', 'END TRACK ends all of it');
for (const each of [page, second]) expect(each.troubles.length === 0, `nothing went wrong: ${each.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
