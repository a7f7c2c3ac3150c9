// node main_path.mjs PIZARRA-CELL SCRATCH: what an operator does with the demo cell, in a real browser.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { ask, expect, keepPicture, launch, openPage, ownFolder, start, tall, taught, taughtCell, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const picture = (page, name, size) => keepPicture(page, join(pictures, `${name}.png`), size);
const served = start([cell, 'console', taughtCell(cell)], folder);
const address = await served.line;

const stranger = await openPage(browser, address.replace(/#.*/, `#${'0'.repeat(64)}`));
await stranger.waitForSelector('#refused[open]');
expect((await stranger.locator('body').getAttribute('data-state')) === 'refused', 'a wrong token is refused');
await stranger.close();

const begun = Date.now();
const page = await openPage(browser, address);
await page.waitForSelector('body[data-state=live]');
await page.waitForFunction(() => /mm/.test(document.getElementById('readings').textContent));
expect(/turned\s*(-?\d+\s+){3}°/.test(await text(page, '#readings')), "the grip's place and turns are shown");
console.log(`the page was alive after ${Date.now() - begun} ms`);
expect(!page.url().includes('#'), 'the token is not left in the address');
expect((await page.evaluate(() => document.cookie)) === '', 'no script sees the cookie');
const elsewhere = await browser.newContext();
const again = await openPage(elsewhere, address);
await again.waitForSelector('#refused[open]');
expect(true, 'a token that was used is refused');
await again.close();

await page.waitForFunction(() =>
  [...document.querySelectorAll('figcaption')].every((f) => /frame \d/.test(f.textContent)),
);
const frame = async () => Number((await text(page, 'figcaption >> nth=0')).match(/frame (\d+)/)[1]);
const first = await frame();
await page.waitForFunction(
  (old) => Number(document.querySelector('figcaption').textContent.match(/frame (\d+)/)[1]) > old + 10,
  first,
);
expect(true, 'images go on coming');

await taught(page);
await ask(page, '(onn ?x ?y)');
await page.waitForSelector('#query-wrong');
expect((await text(page, '#query-wrong')).includes('onn'), 'a question that cannot be asked is refused in words');
await ask(page, '(on ?x ?y)');
await page.click('#tab-story');

await page.fill('#goal-text', '(on circle (triangle)');
await page.press('#goal-text', 'Enter');
await page.waitForSelector('#goal-answer.bad');
expect((await text(page, '#goal-answer')).includes('goal:1:1'), 'what cannot be read says where');
await page.fill('#goal-text', '(on circle trianglo)');
await page.press('#goal-text', 'Enter');
await page.waitForFunction(() => document.getElementById('goal-answer').textContent.includes('the nearest is triangle'));
expect(true, 'an unknown object is refused with the nearest name');

await page.fill('#goal-text', '(on circle triangle) (on triangle square)');
await page.press('#goal-text', 'Enter');
await page.waitForSelector('#plan li.running');
expect((await text(page, '#plan')).includes('PICK-UP'), 'the plan is shown with the operation in hand');
const servoSays = (pattern) => page.waitForFunction((words) => new RegExp(words).test(document.getElementById('servo-note').textContent), pattern);
await servoSays('^(up|align x|align depth|approach|fine): (circle|triangle|square)$');
await page.waitForFunction(() => document.querySelectorAll('#plan li.done').length >= 1);
await page.selectOption('#story select', { label: '2 minutes' });
await page.locator('#goal-text').blur();
await picture(page, 'building');
await page.waitForFunction(() => document.getElementById('goal-answer').textContent.includes('reached'));
await page.waitForFunction(() => document.getElementById('goal-chip').textContent.includes('reached'));
expect(true, 'the goal is reached');
await servoSays('^at rest since \\d\\d:\\d\\d:\\d\\d$');
expect(/ended/.test(await page.getAttribute('#servo-plot', 'class')), 'and the curve of the last approach is faint');
await page.click('#why');
await page.waitForFunction(() => document.querySelector('#story pre.answer').textContent.length > 20);
await page.selectOption('#story select', { label: '10 minutes' });
const lanes = () => page.locator('#work .mark').evaluateAll((marks) => [...new Set(marks.map((mark) => mark.getAttribute('data-lane')))].sort());
await page.waitForFunction(() => document.querySelectorAll('#work .mark[data-lane=Servo]').length > 2);
const worked = await lanes();
expect(['Goals', 'Operations', 'Plans', 'Servo', 'Sightings'].every((lane) => worked.includes(lane)), `what was done, over time: ${worked}`);
await picture(page, 'story');
await ask(page, '(on ?x ?y)');
await page.waitForFunction(() => document.querySelectorAll('#answers tbody tr').length === 2);
expect((await text(page, '#answers')).includes('circle'), 'a question is answered');
await picture(page, 'facts');

await page.fill('#goal-text', '(on cross square) (clear circle)');
await page.press('#goal-text', 'Enter');
await page.waitForFunction(() => /moving/.test(document.getElementById('readings').textContent));
await page.keyboard.press('Escape');
await page.waitForSelector('#stopped:not([hidden])');
await page.waitForFunction(() => /arm\s*(stopped|idle)/.test(document.getElementById('readings').textContent));
expect(true, 'Escape, from within a field, stops the arm');
expect(await page.isDisabled('#clear-stops'), 'who has no arm in hand clears no stop');
await page.click('#tab-drive');
expect(await page.isDisabled('#drive button:text-is("Home")'), 'who has no arm in hand drives none');
await picture(page, 'stopped');
await page.click('#take-arm');
await page.waitForFunction(() => document.getElementById('arm-chip').textContent.includes('your hands'));
await page.click('#clear-stops');
await page.click('#confirm button[value=no]');
expect(await page.isVisible('#stopped'), 'a stop that nobody confirms to clear stands');
await page.click('#clear-stops');
await page.click('#confirm button[value=yes]');
await page.waitForSelector('#stopped', { state: 'hidden' });
expect(true, 'a stop is cleared by who has the arm in hand');
// The coordinator may have given the goal up already.
await page.evaluate(() => document.getElementById('cancel').click());
await page.click('#drive button:text-is("Ready")');
await page.waitForFunction(() => /\(ready\) true/.test(document.querySelector('#drive .log').textContent));
expect(true, 'the arm is driven by who has it in hand');
await page.click('#take-arm');
await page.click('#tab-eyes');
await page.waitForFunction(() => document.querySelectorAll('.objects li').length >= 4);
await page.click('.objects li:has-text("square") button:text("Find")');
await page.waitForFunction(() => /FIND "square" (OK|FAIL)/.test(document.querySelector('#eyes .answer').textContent));
await picture(page, 'eyes', tall);
await page.setViewportSize({ width: 820, height: 1180 });
await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
await page.screenshot({ path: join(pictures, 'tablet.png'), fullPage: true });
expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);

await page.setViewportSize({ width: 1280, height: 800 });
const ended = Date.now();
expect((await served.end()) === 0, 'Ctrl-C ends it in order');
console.log(`ended in ${Date.now() - ended} ms`);
await page.waitForFunction(() => document.body.dataset.state !== 'live');
expect(true, 'the page says that the console is gone');
await browser.close();
process.exit(0);
