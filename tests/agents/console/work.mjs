// node work.mjs PIZARRA-CELL PIZARRA-BOARD SCRATCH: what happened over time in one picture: as far back as the journal
// goes, live and at a moment that has gone by, by pointer and by keys; also where the console began later.

import { join } from 'node:path';
import { expect, expectAccessible, launch, openPage, ownFolder, start, storyBoard, text } from './browser.mjs';

const [cell, board, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const told = storyBoard(board, folder, '--journal', join(folder, 'journal'));
told.tell('work');
const served = start([cell, 'console', '--board', told.at], folder);
const page = await openPage(browser, await served.line);
await page.waitForSelector('body[data-state=live]');

// A mark says how many it stands for: `..., 12:00:00: SENTENCE and 42 more`.
const counted = (marks) => marks.map((label) => 1 + Number(label.match(/ and (\d+) more$/)?.[1] ?? 0)).reduce((a, b) => a + b, 0);
const labels = () => page.locator('#work .mark').evaluateAll((marks) => marks.map((mark) => mark.getAttribute('aria-label')));
const inLane = async (lane) => counted((await labels()).filter((label) => label.startsWith(lane)));
const waitFor = (condition, ...of) => page.waitForFunction(condition, ...of);
const wholeStory = () =>
  waitFor(() => {
    const found = [...document.querySelectorAll('#work .mark[data-lane=Operations]')].map((mark) => mark.getAttribute('aria-label'));
    return found.reduce((sum, label) => sum + 1 + Number(label.match(/ and (\d+) more$/)?.[1] ?? 0), 0) === 43;
  });
await wholeStory();
expect((await page.locator('#story > .timeline details').count()) === 200, 'the list holds the newest 200');
expect((await inLane('Plans')) === 43 && (await inLane('Differences')) === 44, 'the picture holds all of them, by the journal');
const lane = (name, words) =>
  waitFor(
    ([of, like]) => [...document.querySelectorAll(`#work .mark[data-lane=${of}] title`)].some((title) => new RegExp(like).test(title.textContent)),
    [name, words],
  );
const showsApproach = async () => {
  await lane('Servo', 'servo align x: circle');
  await lane('Servo', 'servo fine: circle');
  await lane('Sightings', 'eyes: circle lost since frame 7');
};
expect((await inLane('Servo')) === 44, 'what the servo met');
told.tell('approach');
await showsApproach();
// A page that is opened when all of it is over shows the same.
await page.reload();
await page.waitForSelector('body[data-state=live]');
await wholeStory();
await showsApproach();
expect((await inLane('Servo')) === 44 + 4, 'each of its states once, also of before the page was opened');
expect((await inLane('Sightings')) === 4, 'what came into sight and went');
expect((await inLane('Faults')) === 86, 'what failed, and who went');
// So does a console that is begun when all of it is over.
const later = start([cell, 'console', '--board', told.at, '--journal', join(folder, 'journal')], folder);
const laterPage = await openPage(browser, await later.line);
await laterPage.waitForSelector('body[data-state=live]');
const inLaterLane = (lane) => laterPage.locator(`#work .mark[data-lane=${lane}]`).evaluateAll((marks) => marks.map((mark) => mark.getAttribute('aria-label')));
await laterPage.waitForSelector('#work .mark[data-lane=Sightings]');
await laterPage.waitForFunction(() => [...document.querySelectorAll('#work .mark[data-lane=Servo] title')].some((title) => /servo fine: circle/.test(title.textContent)));
expect(counted(await inLaterLane('Sightings')) === 4, 'by the journal, what came into sight and went before the console began');
expect((await inLaterLane('Servo')).some((label) => /servo align x: circle/.test(label)), 'and what the servo did');
expect((await later.end()) === 0, 'it ends in order');
await laterPage.close();
expect((await labels()).some((label) => /^Goals, .*goal 1 reached: \(on circle triangle\)/.test(label)), 'the goal and its outcome');
expect((await page.locator('#work .mark').count()) < 60, 'and never more marks than can be told apart');

await page.click('#work .mark[data-lane=Plans] >> nth=0');
await page.waitForSelector('#opened details[open]');
expect(/still serves/.test(await text(page, '#opened details[open] summary')), 'a mark opens its entries');
expect(/fact \d+, told by teller/.test(await text(page, '#opened details[open]')), 'each with who told it');
await page.click('#opened > button');

const focused = () => page.evaluate(() => document.activeElement.getAttribute('data-lane') ?? document.activeElement.id);
await page.focus('#work .mark[tabindex="0"]');
const first = await focused();
await page.keyboard.press(first === 'Goals' ? 'ArrowDown' : 'ArrowUp');
const next = await focused();
expect(next !== first, `from lane to lane by keys: ${first}, ${next}`);
await page.keyboard.press('Enter');
await page.waitForSelector('#opened details[open]');
expect(true, 'and opened by a key');
await expectAccessible(page, scratch, 'what happened over time');

const before = await inLane('Differences');
told.tell('more');
await waitFor((old) => {
  const found = [...document.querySelectorAll('#work .mark[data-lane=Differences]')].map((mark) => mark.getAttribute('aria-label'));
  return found.reduce((sum, label) => sum + 1 + Number(label.match(/ and (\d+) more$/)?.[1] ?? 0), 0) === old + 1;
}, before);
expect(true, 'what happens now comes in');

// At the time of the entry, what came later has not happened yet.
await page.click('#story > .timeline details[data-number="100"] summary');
await page.click('#story > .timeline details[data-number="100"] button:text-is("Show all as it was then")');
await waitFor(() => /as it was at/.test(document.getElementById('moment-note').textContent));
await waitFor(() => document.querySelectorAll('#work .mark[data-lane=Goals]').length === 0);
expect((await inLane('Differences')) < before, 'a moment that has gone by has its own picture');
await page.click('#back-to-now');
await waitFor(() => document.querySelectorAll('#work .mark[data-lane=Goals]').length === 1);
expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await told.end();
await browser.close();
process.exit(0);
