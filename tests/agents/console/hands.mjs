// node hands.mjs PIZARRA-CELL SCRATCH: the arm in an operator's hands: a held jog and what ends it, slides, places by
// name, and two pages that want the same arm.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, expectAccessible, launch, openPage, ownFolder, start, taught, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const served = start([cell, 'console'], folder);
const page = await openPage(browser, await served.line);
await page.waitForSelector('body[data-state=live]');
// The person of the cell teaches with the same arm.
await taught(page);
await page.click('#tab-drive');
const button = (label) => page.click(`#drive button:text-is("${label}")`);
const jogs = (direction) => `.jog[data-jog=${direction}]`;
expect(await page.isDisabled(jogs('right')), 'who has no arm in hand jogs none');
await page.click('#take-arm');
await page.waitForSelector(`${jogs('right')}:not(:disabled)`);

// The newest entry of this page in the log that begins so; its answer is null while it is under way.
await page.evaluate(() => {
  window.newest = (wanted) => {
    for (const item of document.querySelectorAll('#drive .log li')) {
      const [, who, told, answer] = [...item.children].map((part) => part.textContent);
      if (who === 'you ' && told.startsWith(wanted)) return { told, answer: answer === ' …' ? null : answer.trim() };
    }
    return { told: '', answer: null };
  };
});
async function answered(command) {
  await page.waitForFunction((wanted) => window.newest(wanted).answer !== null, command);
  return page.evaluate((wanted) => window.newest(wanted), command);
}
// That has been told, and is answered so.
async function done(command, answer = 'true') {
  const entry = await answered(command);
  expect(entry.answer === answer, `${entry.told} ${entry.answer}`);
}
async function driven(label, command) {
  await button(label);
  await done(command);
}
// Where the arm says that it is, once the page shows it: facts come after the answer for which they were told.
async function standing() {
  await button('Monitor');
  const { answer } = await answered('(monitor)');
  const at = answer.split(' ').slice(0, 3).map(Number);
  await page.waitForFunction((told) => {
    const shown = document.getElementById('readings').innerText;
    const grip = shown.match(/grip\s*([-\d]+)\s+([-\d]+)\s+([-\d]+) mm/)?.slice(1);
    return /arm\s*(idle|stopped)/.test(shown) && grip?.every((value, i) => Math.abs(value - told[i]) <= 1);
  }, at);
  return at;
}
const distance = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));

// A page that cannot run in time is silent, or late, and the arm stands: on a machine that is busy elsewhere a person
// presses again, and so does this, to and fro. `begin` and `end` press and let go; `meanwhile`, once the arm moves,
// answers whether it went as it was to. Answers how the jog ended, and from where to where it went.
const tooLate = /came too late|does not hold on|^ok$/;
const lapsed = /has not renewed|came too late|does not hold on|^ok$/;
let way = 'left';
async function jog(begin, end, meanwhile, again = lapsed) {
  for (let attempt = 0; attempt < 30; ++attempt) {
    way = way === 'left' ? 'right' : 'left';
    const command = `(jog ${way})`;
    const from = await standing();
    await begin(jogs(way));
    await page.waitForFunction(
      (told) => window.newest(told).answer || /arm\s*moving\s*\(jog/.test(document.getElementById('readings').innerText),
      command,
    );
    const went = await meanwhile(command, from);
    await end();
    const { answer } = await answered(command);
    if (!again.test(answer)) return { answer, went, from, to: await standing() };
    console.log(`once more: ${answer}`);
  }
  throw new Error('the page was never quick enough to jog');
}
const press = async (selector) => {
  await page.hover(selector);
  await page.mouse.down();
};
const release = () => page.mouse.up();
const isHeld = () => page.evaluate(() => document.querySelector('.jog.held') !== null);

await driven('Ready', '(ready)');

// By the pointer: until it has gone 20 mm, or is over.
const goneFar = async (command, from) => {
  await page.waitForFunction(
    ([told, y]) => {
      const grip = document.getElementById('readings').innerText.match(/grip\s*\S+\s+(\S+)/);
      return Math.abs(Number(grip[1]) - y) > 20 || window.newest(told).answer;
    },
    [command, from[1]],
  );
  return isHeld();
};
const straight = await jog(press, release, goneFar);
expect(straight.answer === 'true' && straight.went, `a jog ends when it is let go: ${straight.answer}`);
const gone = (straight.to[1] - straight.from[1]) * (way === 'right' ? 1 : -1);
const aside = Math.hypot(straight.to[0] - straight.from[0], straight.to[2] - straight.from[2]);
expect(gone > 18 && aside <= 1, `a jog goes straight: ${gone.toFixed(1)} mm, and ${aside.toFixed(2)} mm aside`);
expect(await page.isHidden('#stopped'), 'letting go tells no stop');

// By a key.
const pressKey = async (selector) => {
  await page.focus(selector);
  await page.keyboard.down('Space');
};
const byKey = await jog(pressKey, () => page.keyboard.up('Space'), isHeld);
expect(byKey.answer === 'true' && byKey.went, 'a key jogs, too');

// What takes the page away ends it at once.
for (const [what, happen] of [
  ['losing the focus', () => window.dispatchEvent(new Event('blur'))],
  [
    'being hidden',
    () => {
      Object.defineProperty(document, 'hidden', { value: true, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
      delete document.hidden;
    },
  ],
  [
    'a pointer that is taken away',
    () => document.querySelector('.jog.held')?.dispatchEvent(new PointerEvent('pointercancel')),
  ],
]) {
  const ended = await jog(press, release, async () => {
    await page.evaluate(happen);
    return !(await isHeld());
  });
  expect(ended.answer === 'true' && ended.went, `${what} ends a jog: ${ended.answer}`);
}

// A page that hangs is silent: the arm's own agent stops it.
const hang = async () => {
  await page.screenshot({ path: join(pictures, 'jog.png') });
  await page.evaluate(() => {
    const end = performance.now() + 2000;
    while (performance.now() < end);
  });
};
const silence = await jog(press, release, hang, tooLate);
expect(/has not renewed its hold for \d+ ms/.test(silence.answer), `silence stops the arm: ${silence.answer}`);
await page.waitForFunction(() => /arm\s*stopped/.test(document.getElementById('readings').innerText));

// Spring slides send when they are let go, and go back to zero.
const slide = page.locator('input[aria-label="Move down / up"]');
await slide.hover();
const track = await slide.boundingBox();
await page.mouse.move(track.x + track.width / 2, track.y + track.height / 2);
await page.mouse.down();
await page.mouse.move(track.x + track.width * 0.65, track.y + track.height / 2, { steps: 4 });
const shown = await slide.evaluate((input) => [Number(input.value), input.nextSibling.textContent]);
expect(shown[0] > 5 && shown[1] === `${shown[0]} mm`, 'a slide shows its value while it is held');
await page.mouse.up();
expect((await slide.inputValue()) === '0', 'and springs back');
await done(`(move-v up ${shown[0]})`);

await page.fill('#variable', 'p1');
await driven('Save', '(learn p1)');
const saved = await standing();
await driven('Home', '(home)');
await page.fill('#variable', 'p1');
await driven('Go to', '(goto p1)');
expect(distance(saved, await standing()) <= 2, 'SAVE and GOTO');
const target = [saved[0], saved[1], saved[2] + 30].map(Math.round);
await page.fill('#action', `(move ${target.join(' ')})`);
await driven('Do action', '(do-action');
expect(distance(target, await standing()) <= 2, 'an action typed');
await driven('Finish: report', '(finish report)');

// Another operator.
const other = await browser.newContext();
const second = await openPage(other, await served.next(1));
await second.waitForSelector('body[data-state=live]');
await second.click('#tab-drive');
await second.waitForFunction(() => /Take over from/.test(document.getElementById('take-arm').textContent));
const noted = (of, words) =>
  of.waitForFunction((said) => document.getElementById('hands-note').innerText.includes(said), words);
await second.click('#ask-for-arm');
await noted(page, 'asks for the arm');
await page.screenshot({ path: join(pictures, 'asked-for.png') });
await expectAccessible(page, scratch, 'who asks for the arm');
await second.click('#ask-for-arm');
await page.waitForSelector('#hands-note', { state: 'hidden' });
await second.click('#ask-for-arm');
await noted(page, 'asks for the arm');
await page.click('#hands-note button');
await second.waitForFunction(() => document.getElementById('arm-chip').textContent.includes('your hands'));
await page.waitForFunction(() => /Take over from/.test(document.getElementById('take-arm').textContent));
expect(await second.isHidden('#hands-note'), 'who asks for the arm has it once the other lets it go');
await second.click('#take-arm');
await page.waitForFunction(() => /Take the arm in hand/.test(document.getElementById('take-arm').textContent));
await page.click('#take-arm');
await page.waitForSelector(`${jogs('right')}:not(:disabled)`);
await second.waitForFunction(() => /Take over from/.test(document.getElementById('take-arm').textContent));
await second.click('#take-arm');
await second.click('#confirm button[value=yes]');
await second.waitForSelector(`${jogs('right')}:not(:disabled)`);
await noted(page, 'has taken the arm over');
await noted(second, 'You have taken the arm over from');
expect(true, 'a taking over is told to both');
await page.waitForFunction(() => /arm: console/.test(document.getElementById('arm-chip').textContent));
expect(await page.isDisabled(jogs('right')), 'taking over is told to both');
await page.bringToFront();
await page.screenshot({ path: join(pictures, 'taken-over.png') });
for (const each of [page, second]) expect(each.troubles.length === 0, `nothing went wrong: ${each.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
