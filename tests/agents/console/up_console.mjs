// node up_console.mjs PIZARRA-CELL SCRATCH: a cell as processes with its console: its arm, its images and its world's truth;
// the address comes with the story, and no board and no file of the run holds it. A console that is started beside it
// knows the same cell.

import { execSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, launch, openPage, ownFolder, source, start, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const own = join(folder, 'own.scm');
const blocks = readFileSync(join(source, 'examples/01-blocks/cell.scm'), 'utf8');
writeFileSync(own, blocks.replace('(cell blocks', '(cell own-bench').replace('../../domains', join(source, 'domains')));
const up = start([cell, 'up', own, '--console'], folder);
const address = await up.next(1);
const page = await openPage(browser, address);
const shows = (of, kind, wanted) =>
  of.waitForFunction(([name, like]) => new RegExp(like).test(document.getElementById('scene').dataset[name] ?? ''), [kind, wanted]);
async function showsTheCell(of) {
  await of.waitForSelector('body[data-state=live]');
  await of.waitForFunction(() => /mm/.test(document.getElementById('readings').textContent));
  await of.waitForFunction(() => [...document.querySelectorAll('figcaption')].every((f) => /frame \d/.test(f.textContent)));
  await shows(of, 'arm', '^robot$');
  await shows(of, 'reach', '^true$');
  await of.check('#truth');
  await shows(of, 'truth', '^4$');
  expect(/known to no agent/.test(await text(of, '#truth-note')), 'the world’s truth comes from the world’s own process');
}
await showsTheCell(page);
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

const beside = start([cell, 'console'], folder);
const other = await openPage(await browser.newContext(), await beside.line);
await showsTheCell(other);
expect(true, 'a console beside it needs no file to be named');
expect((await beside.end()) === 0, 'it ends in order');
for (const { troubles } of [page, other]) expect(troubles.length === 0, `nothing went wrong in a page: ${troubles.join('; ')}`);
expect((await up.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
