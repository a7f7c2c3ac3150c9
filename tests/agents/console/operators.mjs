// node operators.mjs PIZARRA-CELL SCRATCH: two pages that want the same arm: asked for, let go, taken over, and stopped by
// who does not have it.

import { join } from 'node:path';
import { begin, expect, expectAccessible, here, openPage } from './browser.mjs';
import { Driving, jogs } from './driving.mjs';

const [cell, scratch] = process.argv.slice(2);
const { browser, served, page, picture, end } = await begin(scratch, [cell, 'console', join(here, 'unattended.scm')]);
await new Driving(page).begin();

// Another operator.
const other = await browser.newContext();
const second = await openPage(other, await served.next(1));
await second.waitForSelector('body[data-state=live]');
await second.click('#tab-drive');
await second.waitForFunction(() => /Take over from page 1$/.test(document.getElementById('take-arm').textContent));
const noted = (of, words) =>
  of.waitForFunction((said) => document.getElementById('hands-note').innerText.includes(said), words);
await second.click('#ask-for-arm');
await noted(page, 'asks for the arm');
await picture('asked-for');
await expectAccessible(page, scratch, 'who asks for the arm');
await second.click('#ask-for-arm');
await page.waitForSelector('#hands-note', { state: 'hidden' });
await second.click('#ask-for-arm');
await noted(page, 'asks for the arm');
await page.click('#hands-note button');
await second.waitForFunction(() => document.getElementById('arm-chip').textContent.includes('your hands'));
await page.waitForFunction(() => /Take over from/.test(document.getElementById('take-arm').textContent));
expect(await second.isHidden('#hands-note'), 'who asks for the arm has it once the other lets it go');
await second.click('#take-arm');
await page.waitForFunction(() => /Take the arm in hand/.test(document.getElementById('take-arm').textContent));
await page.click('#take-arm');
await page.waitForSelector(`${jogs('right')}:not(:disabled)`);
await second.waitForFunction(() => /Take over from/.test(document.getElementById('take-arm').textContent));
await second.click('#take-arm');
await second.click('#confirm button[value=yes]');
await second.waitForSelector(`${jogs('right')}:not(:disabled)`);
await noted(page, 'has taken the arm over');
await noted(second, 'You have taken the arm over from');
expect(true, 'a taking over is told to both');
await page.waitForFunction(() => /arm: page 2/.test(document.getElementById('arm-chip').textContent));
expect(await page.isDisabled(jogs('right')), 'taking over is told to both');
await page.bringToFront();
await picture('taken-over');
await end(second);
