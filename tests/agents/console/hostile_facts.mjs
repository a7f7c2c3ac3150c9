// node hostile_facts.mjs PIZARRA-CELL PIZARRA-BOARD SCRATCH: a board on which somebody tells whatever may hurt a page.

import { spawnSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { ask, expect, launch, openPage, ownFolder, say, skip, source, start, text } from './browser.mjs';

const [cell, board, scratch] = process.argv.slice(2);
if (spawnSync('/usr/bin/python3', ['-c', 'import zmq']).status !== 0)
  skip('python3-zmq is not there to tell facts with');
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
await page.waitForSelector('#story .timeline details');
await page.click('#story .timeline summary');
expect((await text(page, '#story .timeline summary')).includes(script), 'a sentence is shown as it is told');
await page.waitForSelector('#stopped:not([hidden])');
expect((await text(page, '#stopped-by')).includes(script), 'so is a reason');

// The largest that a board takes, and then more at once than anybody reads.
await ask(page, '(bulk ?n ?text)');
const teller = start(['/usr/bin/python3', join(source, 'tests/agents/console/hostile_teller.py'), source, at], folder);
await teller.line;
await page.waitForFunction(() => document.getElementById('query-count').textContent === '4 answers');
expect((await text(page, '#answers')).length < 10_000, 'long text is clipped');
tell('retract', '(stop ? ?)');
await page.waitForSelector('#stopped', { state: 'hidden' });
await page.waitForFunction(() => /^504 /.test(document.getElementById('query-count').textContent));
const pressed = Date.now();
await page.keyboard.press('Escape');
await page.waitForSelector('#stopped:not([hidden])');
console.log(`STOP stood on the page ${Date.now() - pressed} ms after Escape`);
expect(true, 'the flood, which nothing but a stop ends, is stopped from the page');
await teller.ended;
// Four that are large, and some of the five hundred last ones.
const standing = () =>
  [...document.querySelectorAll('#answers tbody tr')]
    .slice(4)
    .every((row) => /"the end <script>/.test(row.textContent));
await page.waitForFunction(standing);
expect(true, 'after the flood the page shows what stands');
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
