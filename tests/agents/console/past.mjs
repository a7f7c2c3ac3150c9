// node past.mjs PIZARRA-CELL SCRATCH: the slider back into the journal: what was known and seen then is shown in the same
// views, and now again; an entry of the story shows what was seen; a board without a journal says so.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, launch, openPage, ownFolder, source, start, taught, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const folder = ownFolder();
const up = start([cell, 'up', join(source, 'examples/01-blocks/cell.scm'), '--console'], folder);
const page = await openPage(browser, await up.next(1));
await page.waitForSelector('body[data-state=live]');
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
await goTo(page, 120);
await page.waitForFunction(() => /as it was at/.test(document.getElementById('moment-note').textContent));
expect((await page.locator('.objects li').count()) < 5, 'then fewer objects were known');
const numbers = () =>
  page.$$eval('#images figcaption', (notes) => notes.map((note) => Number(note.textContent.match(/frame (\d+)/)?.[1])));
const newest = await numbers();
await goTo(page, 900);
await page.waitForFunction(() =>
  [...document.querySelectorAll('#images figcaption')].every((note) => /frame \d+, \d\d:\d\d:\d\d/.test(note.textContent)),
);
const then = await numbers();
await page.waitForFunction(() => /as it was at/.test(document.getElementById('moment-note').textContent));
await page.screenshot({ path: join(pictures, 'past.png') });
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
await page.click('#story .timeline details >> nth=0');
// The goal goes on, and what happens comes in before the entry that is open.
await page.waitForSelector('#story .kept canvas:not([hidden])');
expect(/frame \d+, \d\d:/.test(await text(page, '#story .kept figcaption')), 'an entry of the story shows what was seen');
await page.screenshot({ path: join(pictures, 'story-picture.png') });
await page.click('#story details[open] button:text-is("Show all as it was then")');
await page.waitForFunction(() => /as it was at/.test(document.getElementById('moment-note').textContent));
expect(await page.isEnabled('#back-to-now'), 'and leads to the moment');
await page.click('#back-to-now');
expect((await text(page, '#moment-note')) === 'now', 'and now all of them are again');
await page.waitForFunction(() => /grip/.test(document.getElementById('readings').innerText));
expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
expect((await up.end()) === 0, 'it ends in order');

const served = start([cell, 'console'], ownFolder());
const second = await openPage(browser, await served.line);
await second.waitForSelector('body[data-state=live]');
await goTo(second, 500);
await second.waitForFunction(() => /keeps no journal/.test(document.getElementById('moment-note').textContent));
expect(true, 'a board without a journal says so');
expect((await served.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
