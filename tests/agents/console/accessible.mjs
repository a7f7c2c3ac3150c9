// node accessible.mjs PIZARRA-CELL SCRATCH: axe-core finds nothing serious in any view of the page.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, expectAccessible, launch, openPage, ownFolder, start } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const served = start([cell, 'console'], folder);
const page = await openPage(browser, await served.line);
await page.waitForSelector('body[data-state=live]');
await page.waitForFunction(() => /mm/.test(document.getElementById('readings').textContent));
const look = (view) => expectAccessible(page, scratch, view);
for (const tab of await page.locator('[role=tab]').allInnerTexts()) {
  await page.click(`[role=tab]:text-is("${tab}")`);
  await page.screenshot({ path: join(pictures, `view-${tab.toLowerCase()}.png`) });
  await look(tab);
}
await page.click('#tab-drive');
await page.click('#take-arm');
await page.waitForSelector('.jog:not(:disabled)');
await look('the arm in hand');
await page.keyboard.press('Escape');
await page.waitForSelector('#stopped:not([hidden])');
await look('a stop');
expect((await served.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
