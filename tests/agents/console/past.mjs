// node past.mjs PIZARRA-CELL SCRATCH: the slider back into the journal: what was known then is shown in the same views,
// and now again; a board without a journal says so.

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
await page.screenshot({ path: join(pictures, 'past.png') });
await page.click('#back-to-now');
await known(5);
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
