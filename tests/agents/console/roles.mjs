// node roles.mjs PIZARRA-CELL SCRATCH: a cell with two pairs of eyes as processes. The page looks through those that are
// wired, through others while these are away, and through the wired ones again when they are back.

import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { begin, expect, say, source } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { folder, page, end } = await begin(scratch, [cell, 'up', join(source, 'tests/scenarios/cells/two-of-each.scm'), '--console']);
await page.click('#tab-eyes');
const looksThrough = (eyes) =>
  page.waitForFunction(
    (name) => document.getElementById('eyes-mode').textContent.startsWith(`${name}:`),
    eyes,
    { timeout: 60000 },
  );
await looksThrough('vision');
say([cell, 'repl', '--eval', '(wire console eyes vision-2)'], folder);
await looksThrough('vision-2');
const imagesOf = (eyes) =>
  page.waitForFunction(
    (name) => [...document.querySelectorAll('figure canvas')].every((one) => one.dataset.stream.startsWith(`${name}-`)),
    eyes,
  );
await imagesOf('vision-2');
expect(true, 'the page shows their images and what they tell');

await page.click('#tab-agents');
const served = (words) =>
  page.waitForFunction((row) => document.getElementById('served').innerText.replace(/\s+/g, ' ').includes(row), words, {
    timeout: 60000,
  });
await served('console eyes vision-2');
const ps = (...options) => spawnSync(cell, ['ps', ...options], { encoding: 'utf8', env: { ...process.env, XDG_RUNTIME_DIR: folder } }).stdout;
const { pid } = ps('--json').trim().split('\n').map(JSON.parse).find(({ name }) => name === 'vision-2');
process.kill(pid, 'SIGSTOP');
await served('console eyes vision stands in');
expect(/console's eyes: vision, who stands in/.test(ps()), 'ps shows who stands in');
process.kill(pid, 'SIGCONT');
await served('console eyes vision-2');
await page.click('#tab-eyes');
await looksThrough('vision-2');
expect(true, 'those that are wired serve again when they are back');
await end();
