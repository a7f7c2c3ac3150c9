// node up_console.mjs PIZARRA-CELL SCRATCH: a cell as processes with its console; the address comes with the story, and
// no board and no file of the run holds it.

import { execSync } from 'node:child_process';
import { join } from 'node:path';
import { expect, launch, openPage, ownFolder, source, start } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const up = start([cell, 'up', join(source, 'examples/01-blocks/cell.scm'), '--console'], folder);
const address = await up.next(1);
const page = await openPage(browser, address);
await page.waitForSelector('body[data-state=live]');
await page.waitForFunction(() => /mm/.test(document.getElementById('readings').textContent));
await page.waitForFunction(() =>
  [...document.querySelectorAll('figcaption')].every((f) => /frame \d/.test(f.textContent)),
);
expect(true, 'the page shows the cell that was brought up');
const next = await up.next(2);
expect(next !== address, 'the next browser gets an address of its own');
const secrets = [address, next].map((each) => each.split('#')[1]);
const found = secrets.map((secret) => execSync(`grep -rls ${secret} ${folder} || true`, { encoding: 'utf8' }));
// What the console prints for a person is its log here, which is its owner's alone.
expect(
  found.join('').split('\n').every((file) => file === '' || file.endsWith('console.log')),
  `no other file holds it: ${found}`,
);
expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
expect((await up.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
