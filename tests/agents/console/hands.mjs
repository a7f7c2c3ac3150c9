// node hands.mjs PIZARRA-CELL SCRATCH: the arm in an operator's hands: a held jog and what ends it, slides, places by
// name, and two pages that want the same arm.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { ask, expect, launch, openPage, ownFolder, start, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const served = start([cell, 'console'], folder);
const page = await openPage(browser, await served.line);
await page.waitForSelector('body[data-state=live]');
// The person of the cell teaches with the same arm.
await ask(page, '(person done ?objects)');
await page.waitForFunction(() => document.getElementById('query-count').textContent === '1 answer', null, {
  timeout: 120_000,
});
await page.click('#tab-drive');
const jogs = '.jog[data-jog=right]';
expect(await page.isDisabled(jogs), 'who has no arm in hand jogs none');
await page.click('#take-arm');
await page.waitForSelector(`${jogs}:not(:disabled)`);
const logged = (pattern) =>
  page.waitForFunction((source) => new RegExp(source).test(document.querySelector('#drive .log').innerText), pattern, {
    timeout: 60_000,
  });
await page.click('text=Ready');
await logged('\\(ready\\) true');

const grip = async () => (await text(page, '#readings')).match(/grip\s*([-\d]+)\s+([-\d]+)\s+([-\d]+) mm/).slice(1).map(Number);
const arm = async () => (await text(page, '#readings')).match(/arm\s*(\S+)/)[1];
const moving = () => page.waitForFunction(() => /arm\s*moving/.test(document.getElementById('readings').innerText));
const standing = () => page.waitForFunction(() => /arm\s*(idle|stopped)/.test(document.getElementById('readings').innerText));
const distance = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));

// By the pointer.
const box = await page.locator(jogs).boundingBox();
const at = await grip();
await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
await page.mouse.down();
await moving();
await page.waitForFunction((y) => Number(document.getElementById('readings').innerText.match(/grip\s*\S+\s+(\S+)/)[1]) > y + 20, at[1]);
await page.screenshot({ path: join(pictures, 'jog.png') });
await page.mouse.up();
await standing();
const let_go = await grip();
expect(let_go[1] > at[1] + 20 && Math.abs(let_go[0] - at[0]) <= 1 && Math.abs(let_go[2] - at[2]) <= 1, 'a jog goes straight');
await logged('\\(jog right\\) true');
expect(await page.isHidden('#stopped'), 'letting go tells no stop');

// By a key.
await page.focus('.jog[data-jog=left]');
await page.keyboard.down('Space');
await moving();
await page.keyboard.up('Space');
await standing();
expect(true, 'a key jogs, too');

// What takes the page away ends it. On a machine that is busy elsewhere the page may be silent before: then once more.
async function jogEndedBy(happen) {
  for (let attempt = 0; attempt < 5; ++attempt) {
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.down();
    await moving();
    await page.evaluate(happen);
    await page.waitForFunction(() => !/…/.test(document.querySelector('#drive .log li').innerText));
    await page.mouse.up();
    const ended = await page.locator('#drive .log li >> nth=0').innerText();
    if (!/has not renewed/.test(ended)) return ended;
  }
  return 'silence';
}
for (const [what, happen] of [
  ['losing the focus', () => window.dispatchEvent(new Event('blur'))],
  [
    'being hidden',
    () => {
      Object.defineProperty(document, 'hidden', { value: true, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
      delete document.hidden;
    },
  ],
  [
    'a pointer that is taken away',
    () => document.querySelector('.jog.held')?.dispatchEvent(new PointerEvent('pointercancel')),
  ],
]) {
  const ended = await jogEndedBy(happen);
  expect(/\(jog right\) true/.test(ended), `${what} ends a jog: ${ended}`);
}

// A page that hangs is silent: the arm's own agent stops it.
await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
await page.mouse.down();
await moving();
await page.evaluate(() => {
  const end = performance.now() + 2000;
  while (performance.now() < end);
});
await page.mouse.up();
await logged('has not renewed its hold for \\d+ ms');
expect((await arm()) === 'stopped', 'silence stops the arm');

// Spring slides send when they are let go, and go back to zero.
const slide = page.locator('input[aria-label="Move down / up"]');
await slide.scrollIntoViewIfNeeded();
const track = await slide.boundingBox();
await page.mouse.move(track.x + track.width / 2, track.y + track.height / 2);
await page.mouse.down();
await page.mouse.move(track.x + track.width * 0.65, track.y + track.height / 2, { steps: 4 });
const shown = await slide.evaluate((input) => [Number(input.value), input.nextSibling.textContent]);
expect(shown[0] > 5 && shown[1] === `${shown[0]} mm`, 'a slide shows its value while it is held');
await page.mouse.up();
expect((await slide.inputValue()) === '0', 'and springs back');
await logged(`\\(move-v up ${shown[0]}\\) true`);

await page.fill('#variable', 'p1');
await page.click('text=Save');
await logged('\\(learn p1\\) true');
const saved = await grip();
await page.click('text=Home');
await logged('\\(home\\) true');
await page.fill('#variable', 'p1');
await page.click('text=Go to');
await logged('\\(goto p1\\) true');
expect(distance(saved, await grip()) <= 2, 'SAVE and GOTO');
await page.fill('#action', `(move ${saved[0]} ${saved[1]} ${saved[2] + 30})`);
await page.click('text=Do action');
await logged('do-action .* true');
expect(Math.abs((await grip())[2] - saved[2] - 30) <= 2, 'an action typed');
await page.click('text=Finish: report');
await logged('\\(finish report\\) true');

// Another operator.
const other = await browser.newContext();
const second = await openPage(other, await served.next(1));
await second.waitForSelector('body[data-state=live]');
await second.click('#tab-drive');
await second.waitForFunction(() => /Take over from/.test(document.getElementById('take-arm').textContent));
await second.click('#take-arm');
await second.click('#confirm button[value=yes]');
await second.waitForSelector(`${jogs}:not(:disabled)`);
await page.waitForFunction(() => /arm: console/.test(document.getElementById('arm-chip').textContent));
expect(await page.isDisabled(jogs), 'taking over is told to both');
await page.bringToFront();
await page.screenshot({ path: join(pictures, 'taken-over.png') });
for (const each of [page, second]) expect(each.troubles.length === 0, `nothing went wrong: ${each.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
