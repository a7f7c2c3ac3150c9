// node missing_parts.mjs PIZARRA-CELL SCRATCH: a cell without a robot, and one without eyes: the page is alive, shows what
// there is, says what is missing, and offers nothing that needs it.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, expectAccessible, launch, openPage, ownFolder, start } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);

// A console of a cell that has these agents, and a page of it.
async function serve(agents) {
  const folder = ownFolder();
  const file = join(folder, 'cell.scm');
  writeFileSync(file, `(cell partial (world (cube circle (at 450 -165))) (arm crs-f3) (host "localhost" (agents ${agents})))`);
  const served = start([cell, 'console', file], folder);
  const page = await openPage(browser, await served.line);
  await page.waitForSelector('body[data-state=live]');
  return { page, served };
}
const saysOf = (page, id, words) =>
  page.waitForFunction(([where, said]) => document.getElementById(where).innerText.includes(said), [id, words]);
async function end({ page, served }) {
  expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
  expect((await served.end()) === 0, 'it ends in order');
  await page.close();
}

const eyesAlone = await serve('vision');
const { page } = eyesAlone;
await page.click('#tab-eyes');
await page.click('#eyes button:text-is("Connect")');
await page.waitForFunction(() => document.querySelector('figure canvas').dataset.frame);
expect(true, 'without a robot the images come');
await page.click('#tab-drive');
await saysOf(page, 'service-light', 'No robot is present');
expect(true, 'and the page says that there is none');
const movers = page.locator('#drive .jog, #drive .slides input');
const states = await movers.evaluateAll((all) => all.map((one) => one.disabled && one.title !== ''));
expect(states.length > 10 && states.every(Boolean), 'nothing that moves an arm can be pressed, and says why');
await page.click('#drive button:text-is("Status")');
await page.waitForFunction(() => /no agent robot is present/.test(document.querySelector('#drive .log li')?.textContent));
expect(true, 'a question to it says so, too');
await page.click('#tab-head');
await saysOf(page, 'head-light', 'no head is present');
const turning = await page.locator('#head input[type=range]').evaluateAll((all) => all.map((one) => one.disabled));
expect(turning.length === 4 && turning.every(Boolean), 'without a head nothing turns it');
await expectAccessible(page, scratch, 'a cell without a robot');
await end(eyesAlone);

const armAlone = await serve('robot');
await armAlone.page.waitForFunction(() => /mm/.test(document.getElementById('readings').textContent));
expect(true, 'without eyes the arm is shown');
await saysOf(armAlone.page, 'images', 'no eyes are present');
await armAlone.page.click('#tab-drive');
await saysOf(armAlone.page, 'service-light', 'In service');
await armAlone.page.click('#take-arm');
await armAlone.page.click('#drive button:text-is("Ready"):not(:disabled)');
await armAlone.page.waitForFunction(() => /\(ready\) true/.test(document.querySelector('#drive .log li')?.textContent));
expect(true, 'and moves');
await end(armAlone);
await browser.close();
process.exit(0);
