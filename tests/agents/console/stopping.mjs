// node stopping.mjs PIZARRA-CELL SCRATCH: STOP by Escape from every view, from fields, slides, dialogs and the picture in
// three dimensions, by a page that has no arm in hand.

import { join } from 'node:path';
import { expect, here, launch, openPage, ownFolder, start, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const served = start([cell, 'console', join(here, 'unattended.scm')], folder);
const holder = await openPage(browser, await served.line);
await holder.waitForSelector('body[data-state=live]');
await holder.click('#tab-drive');
await holder.click('#take-arm');
await holder.waitForFunction(() => document.getElementById('arm-chip').textContent.includes('your hands'));
const other = await browser.newContext();
const page = await openPage(other, await served.next(1));
await page.waitForSelector('body[data-state=live]');

// Stops, by the key alone, and has it cleared by who has the arm in hand.
async function stops(where) {
  await page.keyboard.press('Escape');
  await holder.waitForSelector('#stopped:not([hidden])');
  expect(/operator's STOP/.test(await text(holder, '#stopped-by')), `Escape in ${where} stops`);
  await holder.click('#clear-stops');
  await holder.click('#confirm button[value=yes]');
  await page.waitForSelector('#stopped', { state: 'hidden' });
  expect(/Escape/.test(await text(page, '#stop-note')), 'and says so no more once another has cleared it');
}

for (const tab of await page.locator('[role=tab]:visible').allInnerTexts()) {
  await page.click(`[role=tab]:text-is("${tab}")`);
  await stops(tab);
}
await page.click('#tab-facts');
for (const field of ['#goal-text', '#query']) {
  await page.focus(field);
  await stops(field);
}
await page.click('#tab-drive');
await page.click('#take-arm');
await page.waitForSelector('#confirm[open]');
await stops('a dialog');
// A tablet has no Escape.
await page.click('#take-arm');
await page.click('#confirm .stop');
await holder.waitForSelector('#stopped:not([hidden])');
expect(await page.isHidden('#confirm'), 'STOP in a dialog stops, and answers no');
await holder.click('#clear-stops');
await holder.click('#confirm .stop');
await holder.waitForFunction(() => document.getElementById('stop-note').textContent === 'STOP is told');
expect((await holder.isVisible('#stopped')) && (await holder.isHidden('#confirm')), 'also in the one that asks before a stop is cleared');
await holder.click('#clear-stops');
await holder.click('#confirm button[value=yes]');
await page.waitForSelector('#stopped', { state: 'hidden' });
await page.click('#scene');
await stops('the picture of the cell');
await page.click('#stop');
await holder.waitForSelector('#stopped:not([hidden])');
expect(await page.isDisabled('#clear-stops'), 'who has no arm in hand clears none');
expect(/Take the arm in hand first/.test(await text(page, '#why-not-cleared')), 'and reads why');
for (const each of [page, holder]) expect(each.troubles.length === 0, `nothing went wrong: ${each.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
