// node hostile_facts.mjs PIZARRA-CELL PIZARRA-BOARD SCRATCH: a board on which somebody tells whatever may hurt a page.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { ask, expect, launch, openPage, ownFolder, say, start, text } from './browser.mjs';

const [cell, board, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const at = `ipc://${folder}/board`;
const kept = start([board, '--listen', at], folder);
const tell = (word, form) => say([cell, word, '--board', at, form], folder);

tell('declare', '(relation event ((seq integer) (kind symbol) (sentence string) (detail datum)) (key seq) (durable))');
tell('declare', '(relation place ((name symbol) (x number) (y number) (z number) (frame integer)) (key name))');
tell('declare', '(relation stop ((who symbol) (reason string)) (key who) (durable))');
tell('declare', '(relation plan ((n integer) (operations list)) (key) (durable))');
tell('declare', '(relation bulk ((n integer) (text string)) (key n))');

const script = '<script>window.hurt=1</script><img src=x onerror=window.hurt=2>';
const served = start([cell, 'console', '--board', at], folder);
const page = await openPage(browser, await served.line);
await page.waitForSelector('body[data-state=live]');
tell('tell', `(event 1 <img/src=x/onerror=hurt> "${script}" ("${script}"))`);
tell('tell', '(place <script>hurt</script> 400 0 60 1)');
tell('tell', '(place __proto__ 400 100 60 1)');
tell('tell', `(stop <b>somebody</b> "${script}")`);
tell('tell', `(plan 1 ((<script> "${script}") (${'x'.repeat(500)} a)))`);
await page.waitForSelector('#story details');
await page.click('#story summary');
expect((await text(page, '#story summary')).includes(script), 'a sentence is shown as it is told');
await page.waitForSelector('#stopped:not([hidden])');
expect((await text(page, '#stopped-by')).includes(script), 'so is a reason');

// Larger than a message of the wire's could be twice over, and more at once than anybody reads.
for (let n = 0; n < 4; ++n) tell('tell', `(bulk ${n} "${'y'.repeat(100_000)}")`);
await ask(page, '(bulk ?n ?text)');
await page.waitForFunction(() => document.getElementById('query-count').textContent === '4 answers');
expect((await text(page, '#answers')).length < 10_000, 'long text is clipped');
await ask(page, `(event ?n ?kind ?sentence ?detail)`);
await page.waitForFunction(() => document.querySelectorAll('#answers tbody tr').length === 1);

const elements = await page.evaluate(() => ({
  hurt: window.hurt,
  scripts: document.scripts.length,
  images: document.images.length,
  polluted: Object.prototype.x,
}));
expect(elements.hurt === undefined && elements.scripts === 1 && elements.images === 0, 'no fact became HTML');
expect(elements.polluted === undefined, 'no name became a property of all');
expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
mkdirSync(join(scratch, 'console-screenshots'), { recursive: true });
await page.screenshot({ path: join(scratch, 'console-screenshots', 'hostile.png') });
expect((await served.end()) === 0, 'it ends in order');
await kept.end();
await browser.close();
process.exit(0);
