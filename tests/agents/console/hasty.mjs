// node hasty.mjs PIZARRA-CELL SCRATCH: what is typed at great length or is no name, and what is pressed twice.

import { join } from 'node:path';
import { begin, expect, here, reconnections, text } from './browser.mjs';
import { Driving } from './driving.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, end } = await begin(scratch, [cell, 'console', join(here, 'unattended.scm')]);
const driving = new Driving(page);
await driving.begin();
const reconnected = reconnections(page);
const sayGoal = async (goal) => {
  await page.fill('#goal-text', goal);
  await page.press('#goal-text', 'Enter');
  await page.waitForFunction(() => !/asking/.test(document.getElementById('goal-answer').textContent));
  return text(page, '#goal-answer');
};

// More than the console takes in a message.
const long = `(and ${'(on circle triangle) '.repeat(1000)})`;
expect(/16 kB are the most/.test(await sayGoal(long)), 'a goal of 20 kB is refused');
await page.click('#tab-facts');
await page.fill('#query', `(on ${'?x '.repeat(8000)})`);
await page.press('#query', 'Enter');
await page.waitForSelector('#query-wrong:not([hidden])');
expect(/16 kB are the most/.test(await text(page, '#query-wrong')), 'and so is a question');
// These are 17 kB, and fewer letters.
expect(/16 kB are the most/.test(await sayGoal(`(on ${'\u{1F9F1}é\u05d0'.repeat(2100)} b)`)), 'whatever it is written in');
expect(/nothing is called/.test(await sayGoal(`(and ${'(on circle triangle) '.repeat(480)})`)), 'one of 10 kB is read');
expect((await page.getAttribute('#goal-text', 'aria-invalid')) === 'true', 'what is wrong is marked');
await page.fill('#goal-text', '');
expect((await page.getAttribute('#goal-text', 'aria-invalid')) === null, 'until somebody types');
await page.click('#tab-drive');
expect(reconnected.length === 0 && /your hands/.test(await text(page, '#arm-chip')), 'none of it costs the page its connection, or the arm');

// What is no name is refused, and stands in the log as it was typed.
for (const name of ['<img src=x onerror=alert(1)>', '"q\' (', '\u202eabc \u05d0\u05d1', 'x'.repeat(200)]) {
  const wide = () => page.evaluate(() => document.scrollingElement.scrollWidth <= innerWidth);
  await page.fill('#action', name);
  await page.press('#action', 'Enter');
  const { told } = await driving.answered('(do-action');
  expect((await wide()) && told.length > 0, `an action that is none: ${name.slice(0, 30)}`);
}
expect((await page.locator('#drive .log img').count()) === 0, 'text stays text');
const log = await text(page, '#drive .log');
expect(!log.includes('\u202e') && log.includes('\ufffdabc'), 'and turns the direction of no text behind it');

// A double click is one press, also of a button that says something else by its second click.
const stays = async (label) => {
  await page.click('#take-arm');
  await page.waitForSelector(`#take-arm:text-is("${label}")`);
  await page.mouse.down({ clickCount: 2 });
  await page.mouse.up({ clickCount: 2 });
  await driving.driven('Monitor', '(monitor)');
  return (await text(page, '#take-arm')) === label;
};
expect(await stays('Take the arm in hand'), 'who lets the arm go by a double click has let it go');
expect(await stays('Let the arm go'), 'and who takes it so has it');

// Escape while a slide is held, which the hand then draws on.
const slide = page.locator('#drive input[aria-label="Turn left / right"]');
await slide.scrollIntoViewIfNeeded();
const { x, y, width, height } = await slide.boundingBox();
await page.mouse.move(x + width / 2, y + height / 2);
await page.mouse.down();
await page.mouse.move(x + width * 0.6, y + height / 2);
await page.keyboard.press('Escape');
await page.waitForSelector('#stopped:not([hidden])');
await page.mouse.move(x + width * 0.7, y + height / 2);
await page.mouse.up();
expect((await slide.inputValue()) === '0', 'a slide that is held when STOP is told goes back to zero');
await driving.driven('Monitor', '(monitor)');
expect(!/\(turn /.test(await text(page, '#drive .log')), 'and is not sent when it is let go');
await page.click('#clear-stops');
await page.click('#confirm button[value=yes]');
await page.waitForSelector('#stopped', { state: 'hidden' });

await page.dblclick('#stop');
await page.waitForSelector('#stopped:not([hidden])');
expect((await text(page, '#stopped-by')).match(/operator's STOP/g).length === 1, 'STOP that is pressed twice stands once');

await end();
