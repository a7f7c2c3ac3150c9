// node version.mjs PIZARRA-CELL SCRATCH: a page that is of another version than its console, as one that stood in its tab
// while the console was replaced, loads anew once and says so; one that comes back as it was says that, and STOP works.

import { join } from 'node:path';
import { readFileSync } from 'node:fs';
import { expect, here, launch, ownFolder, openPage, pageFolder, start, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const folder = ownFolder();
const served = start([cell, 'console', join(here, 'unattended.scm')], folder);
const browser = await launch(scratch);
const built = (file) => readFileSync(join(pageFolder, 'built', file), 'utf8');
const version = built('version').trim();
const older = built('console.js').replaceAll(version, '0123456789abcdef');

// A page of which so many loads give the older script.
async function openOlder(address, loads) {
  const context = await browser.newContext();
  let loaded = 0;
  await context.route('**/console.js', (route) => {
    loaded += 1;
    return loaded <= loads ? route.fulfill({ contentType: 'text/javascript', body: older }) : route.continue();
  });
  const page = await openPage(context, address);
  return { page, loads: () => loaded };
}

const once = await openOlder(await served.line, 1);
await once.page.waitForSelector('body[data-state=live]');
await once.page.waitForSelector('#version-note:not([hidden])');
expect(/this page was loaded anew/.test(await text(once.page, '#version-said')), 'a page of another version loads anew, and says so');
expect(once.loads() === 2, 'once');
await once.page.click('#version-read');
await once.page.waitForSelector('#version-note', { state: 'hidden' });
await once.page.reload();
await once.page.waitForSelector('body[data-state=live]');
expect(await once.page.isHidden('#version-note'), 'and says it no more afterwards');

const always = await openOlder(await served.next(1), Infinity);
await always.page.waitForSelector('body[data-state=outdated]');
await always.page.waitForSelector('#version-note:not([hidden])');
expect(/did not help/.test(await text(always.page, '#version-said')), 'one that comes back as it was says that');
expect(always.loads() === 2, 'and does not load again and again');
expect((await always.page.isVisible('#line-note')) && (await always.page.getAttribute('#drive', 'inert')) !== null, 'it moves nothing');
await always.page.keyboard.press('Escape');
await once.page.waitForSelector('#stopped:not([hidden])');
expect(/operator's STOP/.test(await text(once.page, '#stopped-by')), 'but its STOP stops');

for (const { page } of [once, always]) expect(page.troubles.length === 0, `nothing went wrong: ${page.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
