// node jogging.mjs PIZARRA-CELL SCRATCH: a held jog, and what ends it.

import { join } from 'node:path';
import { begin, expect, here } from './browser.mjs';
import { Driving, jogs } from './driving.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, picture, end } = await begin(scratch, [cell, 'console', join(here, 'unattended.scm')]);
await page.click('#tab-drive');
expect(await page.isDisabled(jogs('right')), 'who has no arm in hand jogs none');
const driving = new Driving(page);
await driving.begin();

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
    const from = await driving.standing();
    await begin(jogs(way));
    await page.waitForFunction(
      (told) => window.newest(told).answer || /arm\s*moving\s*\(jog/.test(document.getElementById('readings').innerText),
      command,
    );
    const went = await meanwhile(command, from);
    await end();
    const { answer } = await driving.answered(command);
    if (!again.test(answer)) return { answer, went, from, to: await driving.standing() };
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

expect((await driving.driven('Ready', '(ready)')) === 'true', 'READY');

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
  await picture('jog');
  await page.evaluate(() => {
    const end = performance.now() + 2000;
    while (performance.now() < end);
  });
};
const silence = await jog(press, release, hang, tooLate);
expect(/has not renewed its hold for \d+ ms/.test(silence.answer), `silence stops the arm: ${silence.answer}`);
await page.waitForFunction(() => /arm\s*stopped/.test(document.getElementById('readings').innerText));
await end();
