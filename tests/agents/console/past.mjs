// node past.mjs PIZARRA-CELL SCRATCH: back into the journal, by the slider, a time that is typed, or entry by entry: what
// was known and seen then is shown in the same views, and now again; what commands is off then; an entry of the story shows
// what was seen; a board without a journal says so.

import { begin, expect, openPage, ownFolder, reconnections, start, tall, taught, taughtCell, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { browser, page, picture, end } = await begin(scratch, [cell, 'up', taughtCell(cell), '--console']);
await taught(page);
await page.click('#tab-eyes');
const known = (count) =>
  page.waitForFunction((wanted) => document.querySelectorAll('.objects li').length === wanted, count);
await known(5);
// `part` of the way from the oldest to now.
async function goTo(part) {
  await page.waitForSelector('#moment:not(:disabled)');
  await page.evaluate((share) => {
    const slider = document.getElementById('moment');
    slider.value = Math.floor(share * slider.max);
    slider.dispatchEvent(new Event('change'));
  }, part);
}
const shows = (pattern) => page.waitForFunction((words) => new RegExp(words).test(document.getElementById('moment-note').textContent), pattern);
const shownTime = () => page.evaluate(() => document.getElementById('moment-note').textContent.match(/\d\d:\d\d:\d\d/)[0]);
// As far back as it goes.
await goTo(0);
await shows('as it was at');
expect((await page.locator('.objects li').count()) === 0, 'then no objects were known');
// Nothing is commanded by a page that shows what has gone by.
for (const [tab, note, control] of [['eyes', 'eyes', '#training'], ['drive', 'drive', '.jog[data-jog=up]'], ['drive', 'drive', '#drive .slides input'], ['story', 'want', '#go'], ['story', 'want', '#cancel']]) {
  await page.click(`#tab-${tab}`);
  expect(await page.locator(control).first().isDisabled(), `${control} is off`);
  expect(/You look at the past/.test(await text(page, `#why-${note}`)), 'with the reason');
}
expect((await page.isEnabled('#stop')) && (await page.isEnabled('#take-arm')), 'STOP is not');
await page.click('#tab-eyes');
const secondsOf = (time) => time.split(':').reduce((sum, part) => 60 * sum + Number(part), 0);
// Long enough ago that a second after the middle is past as well.
await page.waitForFunction(() => Number(document.getElementById('moment').max) >= 4);
await goTo(0.5);
await shows('as it was at');
const middle = await shownTime();
await page.focus('#moment');
await page.keyboard.press('ArrowRight');
await shows('as it was at');
expect(secondsOf(await shownTime()) === secondsOf(middle) + 1, 'an arrow key goes a second further');
await page.fill('#moment-time', middle);
await page.press('#moment-time', 'Enter');
await shows(`as it was at ${middle}`);
expect(true, `a time that is typed is shown: ${middle}`);
for (const [typed, wrong] of [['25:00', 'write a time'], ['noon', 'write a time'], ['00:00:00', 'nothing is known from before'], ['23:59:59', 'yet to come']]) {
  await page.fill('#moment-time', typed);
  await page.press('#moment-time', 'Enter');
  const said = await page.$eval('#moment-time', (field) => field.validationMessage);
  expect(said.includes(wrong), `${typed}: ${said}`);
}
expect((await shownTime()) === middle, 'and what is none changes nothing');
await page.fill('#moment-time', middle);
await page.press('#moment-time', 'Enter');
await shows(`as it was at ${middle}`);
const numbers = () =>
  page.$$eval('#images figcaption', (notes) => notes.map((note) => Number(note.textContent.match(/frame (\d+)/)?.[1])));
const newest = await numbers();
await goTo(0.9);
await page.waitForFunction(() =>
  [...document.querySelectorAll('#images figcaption')].every((note) => /frame \d+, \d\d:\d\d:\d\d/.test(note.textContent)),
);
const then = await numbers();
await shows('as it was at');
expect((await page.inputValue('#moment-time')) === (await shownTime()), 'the field shows the time that is shown');
await picture('past');
await page.click('#back-to-now');
await known(5);
await page.waitForFunction(
  (old) => Number(document.querySelector('#images figcaption').textContent.match(/frame (\d+)$/)?.[1]) > old,
  Math.max(...then),
);
expect(then.every((number) => number > 0), `what was seen then was shown: frames ${then}, and before ${newest}`);
await page.fill('#goal-text', '(on circle triangle)');
await page.press('#goal-text', 'Enter');
await page.waitForSelector('#plan li.running');
await page.click('#tab-story');
// Others may come before it meanwhile.
const number = await page.getAttribute('#story > .timeline details >> nth=0', 'data-number');
const entry = page.locator(`#story > .timeline details[data-number="${number}"]`);
await entry.locator('summary').click();
await entry.locator('.kept canvas:not([hidden])').waitFor();
expect(/frame \d+, \d\d:/.test(await entry.locator('.kept figcaption').innerText()), 'an entry of the story shows what was seen');
await page.setViewportSize(tall);
await entry.evaluate((one) => one.scrollIntoView({ block: 'start' }));
await picture('story-picture');
await entry.locator('button:text-is("Show all as it was then")').click();
await shows('as it was at');
expect(await page.isEnabled('#back-to-now'), 'and leads to the moment');
const told = (await entry.locator('summary time').innerText()).trim();
expect((await shownTime()) === told, 'of the entry');
const newestIs = (wanted) => page.waitForFunction((entry) => Number(document.querySelector('#story > .timeline details').dataset.number) === entry, wanted);
await newestIs(Number(number));
await page.click('#past button:text-is("◂ Entry")');
await newestIs(Number(number) - 1);
await page.focus('#moment');
await page.keyboard.press('PageUp');
await newestIs(Number(number));
expect(true, 'buttons and keys go from entry to entry');
// Whoever changes their mind before a moment is shown sees the one that they chose last.
await goTo(0.3);
await page.click('#back-to-now');
await page.waitForFunction(() => document.getElementById('moment-note').textContent === 'now');
await known(5);
await page.waitForFunction(() => /grip/.test(document.getElementById('readings').innerText));
expect(!(await page.evaluate(() => document.body.classList.contains('past'))), 'and now all of them are again');
// To and fro, as quick as keys are. A question behind all that comes by the same connection, or another had to be opened.
const reconnected = reconnections(page);
await page.focus('#moment');
for (let i = 0; i < 40; ++i) await page.keyboard.press(i % 2 ? 'End' : 'Home');
await taught(page);
expect(reconnected.length === 0, 'however quick that is, the page says no more than the console takes');
await page.waitForFunction(() => document.getElementById('moment-note').textContent === 'now' && !document.body.classList.contains('past'));
expect(true, 'and shows what was chosen last');
const served = start([cell, 'console'], ownFolder());
const second = await openPage(browser, await served.line);
await second.waitForSelector('body[data-state=live]');
const whyNoPast = (words) => second.waitForFunction((said) => document.getElementById('why-no-past').textContent.includes(said), words);
await whyNoPast('this board keeps no journal');
for (const control of ['#moment', '#moment-time']) expect(await second.isDisabled(control), `${control} is off where there is no journal, which is said`);
expect((await served.end()) === 0, 'it ends in order');
await second.waitForSelector('body:not([data-state=live])');
await whyNoPast('no live line');
expect(true, 'and where the console has gone, which is said');
await end(second);
