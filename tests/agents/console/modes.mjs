// node modes.mjs PIZARRA-CELL SCRATCH: the eyes' modes, for two pages at once: CONNECT and DISCONNECT, what excludes what
// and why a button is off, FIND's cross, TRACK of several objects and END TRACK.

import { begin, expect, openPage, taught, taughtCell, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { browser, served, page, picture, end } = await begin(scratch, [cell, 'console', taughtCell(cell)]);
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

// FIND: the answer has the thesis' words, and the picture of the dark mark a white cross there, a pixel thin, for three
// seconds. Where the browser is slow the pictures are light, half as wide; then it is asked once more.
const isCrossed = ([cx, cy]) => {
  const canvas = document.querySelectorAll('figure canvas')[1];
  if (canvas.width !== 640) return false;
  const [x, y] = [2 * cx + 0.5, 2 * cy + 0.5].map(Math.round);
  const { data } = canvas.getContext('2d').getImageData(x - 10, y - 10, 21, 21);
  const level = (dx, dy) => data[4 * (21 * (dy + 10) + dx + 10) + 1];
  const across = [-2, -1, 0, 1, 2];
  const brightness = (levels) => levels.reduce((sum, one) => sum + one, 0);
  const beside = [[-6, -6], [6, -6], [-6, 6], [6, 6]].map(([dx, dy]) => level(dx, dy));
  const ground = 5 * Math.max(...beside);
  return [-8, -6, -3, 3, 6, 8].every(
    (along) =>
      brightness(across.map((off) => level(along, off))) - ground > 100 &&
      brightness(across.map((off) => level(off, along))) - ground > 100,
  );
};
const circle = () => text(page, '#eyes-answer').then((said) => said.match(/\(([\d.]+), ([\d.]+)\)/).slice(1).map(Number));
for (let attempt = 0, crossed = false; !crossed; ++attempt) {
  if (attempt === 20) throw new Error('FIND never drew its cross');
  await row(page, 'circle', 'Find').click();
  await page.waitForFunction(() => /^\(FIND "circle" OK/.test(document.getElementById('eyes-answer').textContent));
  crossed = await page.waitForFunction(isCrossed, await circle(), { timeout: 3000, polling: 'raf' }).then(() => true, () => false);
}
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
await picture('tracking-several');
for (const [of, what] of [[page, 'own'], [second, 'another page’s']]) {
  await of.waitForSelector('#training:disabled');
  expect(/tracks?, which excludes learning/.test(await of.getAttribute('#training', 'title')), `${what} tracking excludes learning`);
  expect(/Training, Add sample, Forget: .*tracks?, which excludes learning/.test(await text(of, '#why-eyes')), 'in words beside it');
  expect(/tracks?, which excludes learning/.test(await row(of, 'cross', 'Forget').getAttribute('title')), 'and forgetting');
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
await end(second);
