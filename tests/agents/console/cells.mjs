// node cells.mjs PIZARRA-CELL PIZARRA-BOARD SCRATCH: a hall's board names cells. The page lists how they do, leads to
// their consoles, and says of which it is not known. No name and no address of another board hurts it.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, expectAccessible, keepPicture, launch, openPage, ownFolder, say, start } from './browser.mjs';

const [cell, board, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const at = (name) => `ipc://${join(folder, name)}`;
const boards = new Map();
for (const name of ['hall', 'north', 'blocks', 'kits', 'sorting', 'away']) boards.set(name, start([board, '--listen', at(name)], folder));
await Promise.all([...boards.values()].map(({ line }) => line));
const served = start([cell, 'console', '--board', at('hall')], folder);
const page = await openPage(browser, await served.line);
await page.waitForSelector('body[data-state=live]');
expect(await page.locator('#tab-cells').isHidden(), 'a board that names no cells has no page of them');

const relations = [
  'agent ((name symbol) (kind symbol) (host string)) (key name)',
  'goal ((n integer) (goal list)) (key n)',
  'goal-state ((n integer) (state symbol) (detail datum)) (key n)',
  'arm ((robot symbol) (state symbol) (action string)) (key robot)',
  'stop ((who symbol) (reason string)) (key who)',
  'event ((n integer) (kind symbol) (sentence string) (detail datum)) (key n)',
  'console-address ((client symbol) (address string)) (key client)',
];
const tell = (name, ...facts) => {
  for (const fact of facts) say([cell, 'tell', '--board', at(name), fact], folder);
};
const lead = (from, name, to) => say([cell, 'contexts', '--board', at(from), '--add', `${name}=${at(to)}`], folder);
for (const name of ['blocks', 'kits', 'sorting']) {
  for (const relation of relations) say([cell, 'declare', '--board', at(name), `(relation ${relation})`], folder);
  for (const agent of ['robot', 'vision', 'planner', 'coordinator']) tell(name, `(agent ${agent} ${agent} "bench")`);
}
tell(
  'blocks',
  '(goal 3 ((on circle lid)))',
  '(goal-state 3 running ())',
  '(arm robot moving "go to the circle")',
  '(event 1 plan "the plan has two operations" ())',
  '(console-address console "https://blocks:7950/")',
);
tell('kits', '(goal 12 ((kit tray-1)))', '(goal-state 12 reached ())', '(arm robot idle "ready")');
tell('kits', '(event 40 goal "goal 12 is reached" ())');
tell('sorting', '(goal 7 ((in square tray-2)))', '(goal-state 7 running ())', '(stop anna "a hand is in the cell")');
tell('sorting', '(arm robot stopped "anna: a hand is in the cell")', '(event 9 stop "the arm stands" ())');
lead('hall', 'north', 'north');
lead('north', 'blocks', 'blocks');
lead('north', 'kits', 'kits');
lead('hall', 'sorting', 'sorting');
lead('hall', 'away', 'away');
await boards.get('away').end();

await page.click('#tab-cells');
const row = (name) => page.locator('#cells-table tbody tr').filter({ has: page.locator('td:first-child', { hasText: name }) });
const words = async (name) => (await row(name).innerText()).replace(/\s+/g, ' ').trim();
await row('away').filter({ hasText: 'the board does not answer' }).waitFor();
const blocks = 'north/blocks 4 3 running (on circle lid) robot moving the plan has two operations';
expect((await words('north/blocks')) === blocks, `how a cell does: ${await words('north/blocks')}`);
expect((await words('sorting')).includes('anna: a hand is in the cell'), `who stopped it: ${await words('sorting')}`);
const link = row('north/blocks').locator('a');
expect((await link.getAttribute('href')) === 'https://blocks:7950/', 'its name leads to its console');
await keepPicture(page, join(pictures, 'cells.png'), { width: 1280, height: 480 });
await expectAccessible(page, scratch, 'the cells');
await link.focus();
const before = await row('north/blocks').elementHandle();
await page.waitForFunction((old) => !old.isConnected, before);
expect(await link.evaluate((one) => one === document.activeElement), 'the focus stays at the link when the table is filled anew');

// What another board says is text, and leads to no other place.
tell('blocks', '(console-address console "javascript:alert(1)")', '(event 2 plan "<img src=x onerror=alert(2)>" ())');
tell('hall', `(context-board <img/src=x/onerror=alert> "${at('blocks')}")`, '(context-board nowhere "nonsense")');
tell('north', `(context-board up "${at('hall')}")`);
await row('north/up').filter({ hasText: 'it is the first board, listed already' }).waitFor();
expect(!(await words('nowhere')).includes('running'), `an address that is none is told: ${await words('nowhere')}`);
await row('<img/src=x/onerror=alert>').filter({ hasText: '<img src=x onerror=alert(2)>' }).waitFor();
expect((await page.locator('#cells-table img, #cells-table a').count()) === 0, 'nothing of it is read as HTML');

// The hall's own board goes.
await boards.get('hall').end();
await row('this one').filter({ hasText: 'the board does not answer' }).waitFor();
expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
for (const name of ['north', 'blocks', 'kits', 'sorting']) await boards.get(name).end();
await browser.close();
process.exit(0);
