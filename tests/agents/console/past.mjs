// node past.mjs PIZARRA-CELL SCRATCH: the slider back into the journal: what was known and seen then is shown in the same
// views, and now again; an entry of the story shows what was seen; a board without a journal says so.

import { join } from 'node:path';
import { begin, expect, openPage, ownFolder, source, start, tall, taught, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const blocks = join(source, 'examples/01-blocks/cell.scm');
const { browser, page, picture, end } = await begin(scratch, [cell, 'up', blocks, '--console']);
await taught(page);
await page.click('#tab-eyes');
const known = (count) =>
  page.waitForFunction((wanted) => document.querySelectorAll('.objects li').length === wanted, count);
await known(5);
async function goTo(of, part) {
  await of.waitForSelector('#moment:not(:disabled)');
  await of.evaluate((value) => {
    const slider = document.getElementById('moment');
    slider.value = value;
    slider.dispatchEvent(new Event('change'));
  }, part);
}
// As far back as it goes.
await goTo(page, 0);
await page.waitForFunction(() => /as it was at/.test(document.getElementById('moment-note').textContent));
expect((await page.locator('.objects li').count()) === 0, 'then no objects were known');
// Nothing is commanded by a page that shows what has gone by.
for (const [tab, note, control] of [['eyes', 'eyes', '#training'], ['drive', 'drive', '.jog[data-jog=up]'], ['drive', 'drive', '#drive .slides input'], ['story', 'want', '#go'], ['story', 'want', '#cancel']]) {
  await page.click(`#tab-${tab}`);
  expect(await page.locator(control).first().isDisabled(), `${control} is off`);
  expect(/You look at the past/.test(await text(page, `#why-${note}`)), 'with the reason');
}
expect((await page.isEnabled('#stop')) && (await page.isEnabled('#take-arm')), 'STOP is not');
await page.click('#tab-eyes');
const numbers = () =>
  page.$$eval('#images figcaption', (notes) => notes.map((note) => Number(note.textContent.match(/frame (\d+)/)?.[1])));
const newest = await numbers();
await goTo(page, 900);
await page.waitForFunction(() =>
  [...document.querySelectorAll('#images figcaption')].every((note) => /frame \d+, \d\d:\d\d:\d\d/.test(note.textContent)),
);
const then = await numbers();
await page.waitForFunction(() => /as it was at/.test(document.getElementById('moment-note').textContent));
await picture('past');
await page.click('#back-to-now');
await known(5);
await page.waitForFunction(
  (old) => Number(document.querySelector('#images figcaption').textContent.match(/frame (\d+)$/)?.[1]) > old,
  Math.max(...then),
);
expect(then.every((number) => number > 0), `what was seen then was shown: frames ${then}, and before ${newest}`);
await page.fill('#goal-text', '(on circle triangle)');
await page.press('#goal-text', 'Enter');
await page.waitForSelector('#plan li.running');
await page.click('#tab-story');
// Others may come before it meanwhile.
const number = await page.getAttribute('#story > .timeline details >> nth=0', 'data-number');
const entry = page.locator(`#story > .timeline details[data-number="${number}"]`);
await entry.locator('summary').click();
await entry.locator('.kept canvas:not([hidden])').waitFor();
expect(/frame \d+, \d\d:/.test(await entry.locator('.kept figcaption').innerText()), 'an entry of the story shows what was seen');
await page.setViewportSize(tall);
await entry.evaluate((one) => one.scrollIntoView({ block: 'start' }));
await picture('story-picture');
await entry.locator('button:text-is("Show all as it was then")').click();
await page.waitForFunction(() => /as it was at/.test(document.getElementById('moment-note').textContent));
expect(await page.isEnabled('#back-to-now'), 'and leads to the moment');
// Whoever changes their mind before a moment is shown sees the one that they chose last.
await goTo(page, 300);
await page.click('#back-to-now');
await known(5);
await page.waitForFunction(() => /grip/.test(document.getElementById('readings').innerText));
expect((await text(page, '#moment-note')) === 'now', 'and now all of them are again');
const served = start([cell, 'console'], ownFolder());
const second = await openPage(browser, await served.line);
await second.waitForSelector('body[data-state=live]');
await goTo(second, 500);
await second.waitForFunction(() => /keeps no journal/.test(document.getElementById('moment-note').textContent));
expect(true, 'a board without a journal says so');
expect((await served.end()) === 0, 'it ends in order');
await second.waitForSelector('body:not([data-state=live])');
await goTo(second, 300);
await second.waitForFunction(() => /the console is not connected/.test(document.getElementById('moment-note').textContent));
expect(true, 'and a console that has gone shows no past, which is said');
await end(second);
