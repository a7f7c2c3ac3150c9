// node wanting.mjs PIZARRA-CELL PIZARRA-BOARD SCRATCH: how far a plan has come, and a goal written with what may come
// next.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { expect, expectAccessible, launch, openPage, ownFolder, pageFolder, start, storyBoard } from './browser.mjs';

const { nextWords } = await import(pathToFileURL(join(pageFolder, 'src/goal_words.js')));
const known = { predicates: new Map([['on', 2], ['clear', 1], ['arm-empty', 0]]), names: ['circle', 'cross', 'square'] };
const put = (source) => nextWords(source, known).words.map((word) => word.put);
expect(put('(o').join() === 'on ,or ', 'a head: predicates, and words of the language of goals');
expect(put('(on c').join() === 'circle ,cross ', 'an object');
expect(put('(on circle c').join() === 'cross)', 'the last one closes the fact, and none stands twice');
expect(put('(and (clear s').join() === 'square)', 'within another form');
expect(put('(arm').join() === 'arm-empty)', 'what is said of nothing is complete');
expect(put('(and (on circle cross) cl').join() === '(clear ', 'within `and` a fact begins');
expect(put('(on circle cross').length === 0 && put('(on circle cross s').length === 0, 'what is complete is left alone');

const [cell, board, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const told = storyBoard(board, folder);
told.tell('serve');
const served = start([cell, 'console', '--board', told.at], folder);
const page = await openPage(browser, await served.line);
await page.waitForSelector('body[data-state=live]');

await page.waitForFunction(() => document.querySelectorAll('#plan li').length === 4 && document.querySelector('#plan li.skipped'));
const rows = (await page.locator('#plan li').allInnerTexts()).map((row) => row.replace(/\s+/g, ' ').trim());
expect(
  rows.join('; ') === '(PICK-UP triangle) done; (STACK triangle square) skipped; (PICK-UP circle) running; (STACK circle triangle) still serves',
  `how far the plan has come: ${rows.join('; ')}`,
);

const goal = () => page.inputValue('#goal-text');
const offered = () => page.locator('#goal-text-words li').allInnerTexts();
await page.click('#goal-text');
await page.keyboard.type('(o');
await page.waitForSelector('#goal-text-words:not([hidden])');
expect((await offered()).join() === 'on,or', `what may come next: ${await offered()}`);
await page.screenshot({ path: join(pictures, 'completion.png') });
await expectAccessible(page, scratch, 'what may come next');
await page.keyboard.press('Tab');
expect((await goal()) === '(on ', 'Tab takes the first');
expect((await offered()).join() === 'circle,square,triangle', `objects, and not the gripper: ${await offered()}`);
await page.keyboard.press('ArrowDown');
await page.keyboard.press('ArrowDown');
await page.keyboard.press('Enter');
await page.locator('#goal-text-words li:text-is("triangle")').click();
expect((await goal()) === '(on square triangle)', `by arrow keys and by pointer: ${await goal()}`);
expect(await page.isHidden('#goal-text-words'), 'a complete fact has nothing to come');
expect((await page.evaluate(() => document.activeElement.id)) === 'goal-text', 'the field is left where one types on');

await page.fill('#goal-text', '(on circle (triangle)');
await page.press('#goal-text', 'Enter');
await page.waitForSelector('#goal-answer.bad');
const marked = () => page.evaluate(() => {
  const field = document.getElementById('goal-text');
  return field.getAttribute('aria-invalid') + field.value.slice(field.selectionStart, field.selectionEnd);
});
expect((await marked()) === 'true(', `the place of a mistake is marked in the field: ${await marked()}`);
expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await told.end();
await browser.close();
process.exit(0);
