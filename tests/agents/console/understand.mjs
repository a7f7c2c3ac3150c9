// node understand.mjs PIZARRA-CELL PIZARRA-BOARD SCRATCH: why it did what it did: the old and the new plan side by side,
// the goals and their outcomes, and because of what a fact was told.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { ask, expect, expectAccessible, launch, openPage, ownFolder, reconnections, start, storyBoard, tall, text } from './browser.mjs';

const [cell, board, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const told = storyBoard(board, folder, '--journal', join(folder, 'journal'));
told.tell();
const served = start([cell, 'console', '--board', told.at], folder);
const page = await openPage(browser, await served.line);
await page.waitForSelector('body[data-state=live]');
const reconnected = reconnections(page);

// The plan that was made anew, beside the one before.
const entry = (number) => page.locator(`#story details[data-number="${number}"]`);
await entry(6).locator('summary').click();
const rows = await entry(6).locator('tbody tr').allInnerTexts();
const plain = rows.map((row) => row.replace(/\s+/g, ' ').trim());
expect(
  plain.join('; ') ===
    '(PICK-UP triangle) begun; (STACK triangle square) begun; (UNSTACK cross triangle) new; (PUT-DOWN cross) new; ' +
      '(PICK-UP circle) (PICK-UP circle) kept; (STACK circle triangle) (STACK circle triangle) kept',
  `two plans side by side: ${plain.join('; ')}`,
);
await entry(6).screenshot({ path: join(pictures, 'plans.png') });
await entry(2).locator('summary').click();
expect((await entry(2).locator('table').count()) === 0, "a goal's first plan has none before it");

// What an operation was ordered by, what was expected, and what was believed then.
await entry(4).locator('summary').click();
await entry(4).locator('.why').waitFor();
const why = (await entry(4).locator('.why').innerText()).replace(/\s+/g, ' ');
for (const words of [
  'Ordered by goal 1: (on circle triangle) (on triangle square)',
  'Step 2 of 4',
  'Expected before (holding triangle) holds (clear square) does not hold',
  'Expected after (on triangle square) (arm-empty)',
  'Believed then (holding triangle)',
])
  expect(why.includes(words), `an operation's entry says by what it was ordered: ${words} in ${why}`);
expect((await entry(4).locator('.ordered [aria-current=step]').innerText()) === '(STACK triangle square)', 'and marks its step in the plan');
// A difference shows what the operation in hand expected.
await entry(5).locator('summary').click();
await entry(5).locator('.why .lacks').waitFor();
expect(/Step 2 of 4/.test((await entry(5).locator('.why').innerText()).replace(/\s+/g, ' ')), 'so does a difference');
await page.locator('#story').evaluate((panel) => panel.scrollTo(0, 0));

await page.click('.goals summary');
const goals = (await page.locator('#goals tbody tr').allInnerTexts()).map((row) => row.replace(/\s+/g, ' '));
expect(/^2 \(on circle trianglo\) refused there is no trianglo/.test(goals[0]), `goals and outcomes: ${goals[0]}`);
expect(/^1 \(on circle triangle\) \(on triangle square\) running/.test(goals[1]), `goals and outcomes: ${goals[1]}`);
await page.screenshot({ path: join(pictures, 'understand.png') });
await expectAccessible(page, scratch, 'the plans and the goals');

// Because of what a fact was told, and that because of what.
await ask(page, '(believed ?fact)');
await page.click('#answers button.because');
await page.waitForSelector('#because:not([hidden])');
const facts = await page.locator('#because .fact').allInnerTexts();
expect(/\(believed \(on circle triangle\)\)/.test(facts[0]), 'the fact');
expect(/\(place circle 400 0 60 7\)/.test(facts[1]), 'its reason');
expect(facts.some((fact) => /\(look eyes 7 "TRACK" \(\)\)\s*fact \d+, by teller/.test(fact)), "its reason's reason");
const gone = facts.find((fact) => /gone since/.test(fact)) ?? '';
expect(/\(look eyes 8 "TRACK" \(\)\)\s*fact \d+, by teller/.test(gone), `and one that has gone since, from the journal: ${gone}`);
expect(facts.length === 4 && (await page.locator('#because ul ul ul > li').count()) === 2, 'each behind what it is the reason of');
await page.setViewportSize(tall);
await page.locator('#because').screenshot({ path: join(pictures, 'because.png') });
await expectAccessible(page, scratch, 'the reasons');
expect((await text(page, '#query-count')) === '1 answer', 'the question goes on');

// Whom the board refused what.
await ask(page, '(nobody-told ?this)');
await page.waitForSelector('#query-wrong');
await page.click('#tab-agents');
await page.click('#agents summary:has-text("Refused")');
const refusal = page.locator('#refusals tbody tr:has-text("undeclared-relation")');
await refusal.waitFor();
const refused = await refusal.innerText();
expect(/^this page\s+undeclared-relation\s+1\s.*nobody-told/s.test(refused), `who was refused what, once: ${refused}`);
await expectAccessible(page, scratch, 'the refusals');
expect(reconnected.length === 0, 'the connection was never lost');
expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await told.end();
await browser.close();
process.exit(0);
