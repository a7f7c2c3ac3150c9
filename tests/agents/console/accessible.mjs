// node accessible.mjs PIZARRA-CELL SCRATCH: axe-core finds nothing serious in any view of the page.

import { begin, expectAccessible, taughtCell } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, picture, end } = await begin(scratch, [cell, 'console', taughtCell(cell)]);
await page.waitForFunction(() => /mm/.test(document.getElementById('readings').textContent));
const look = (view) => expectAccessible(page, scratch, view);
for (const tab of await page.locator('[role=tab]:visible').allInnerTexts()) {
  await page.click(`[role=tab]:text-is("${tab}")`);
  await picture(`view-${tab.toLowerCase()}`);
  await look(tab);
}
await page.click('#tab-drive');
await page.click('#take-arm');
await page.waitForSelector('.jog:not(:disabled)');
await look('the arm in hand');
await page.keyboard.press('Escape');
await page.waitForSelector('#stopped:not([hidden])');
await look('a stop');
await end();
