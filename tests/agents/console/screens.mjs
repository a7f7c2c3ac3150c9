// node screens.mjs PIZARRA-CELL SCRATCH: the page on a 13-inch laptop and on a tablet, upright and across: nothing sticks
// out, is cut or lies over another, every control can be reached and is large enough for a finger, and a finger holds a
// jog.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, expectAccessible, here, launch, openPage, ownFolder, start } from './browser.mjs';
import { Driving, jogs } from './driving.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const served = start([cell, 'console', join(here, 'unattended.scm')], folder);
let next = await served.line;

const screens = [
  { name: 'laptop', width: 1280, height: 800, touch: false },
  { name: 'low-laptop', width: 1280, height: 720, touch: false },
  { name: 'tablet-across', width: 1024, height: 768, touch: true },
  { name: 'tablet-upright', width: 768, height: 1024, touch: true },
];

// Of every control that is shown: what sticks out of the window once it is scrolled to, is covered, or too small.
const awkward = (page) =>
  page.evaluate(() => {
    const wrong = [];
    for (const control of document.querySelectorAll('button, input, summary, [role=tab]')) {
      if (!control.checkVisibility() || control.closest('dialog')) continue;
      control.scrollIntoView({ block: 'center', inline: 'nearest' });
      const box = control.getBoundingClientRect();
      const name = control.getAttribute('aria-label') || control.textContent || control.id;
      const size = `${Math.round(box.width)} x ${Math.round(box.height)}`;
      // WCAG 2.2, 2.5.8; a check box has its label, too, and a range its whole length.
      const small = control.type === 'checkbox' || control.type === 'range' ? 12 : 24;
      if (box.height < small || box.width < small) wrong.push(`${name} is small: ${size}`);
      if (box.left < 0 || box.right > innerWidth + 1) wrong.push(`${name} sticks out: ${Math.round(box.left)} to ${Math.round(box.right)}`);
      const at = document.elementFromPoint(box.left + box.width / 2, box.top + box.height / 2);
      if (!at || !(control.contains(at) || at.contains(control))) wrong.push(`${name} is covered by ${at?.id || at?.tagName}`);
    }
    return wrong;
  });

// Of what is shown: what lies over another in its panel, and what does not fit into its button or card.
const crowded = (page) =>
  page.evaluate(() => {
    const name = (one) => one.getAttribute('aria-label') || one.textContent.trim().slice(0, 40) || one.id;
    const isShown = (one) => one.checkVisibility() && !one.closest('dialog') && one.getBoundingClientRect().width > 0;
    const wrong = [];
    for (const panel of document.querySelectorAll('header, #past, #want, [role=tabpanel]:not([hidden])')) {
      const parts = [...panel.querySelectorAll('button, input, select, output, .reasons, h1, h2, .chip')].filter(isShown);
      const boxes = parts.map((one) => ({ one, box: one.getBoundingClientRect() }));
      for (const [i, { one, box }] of boxes.entries()) {
        for (const { one: other, box: at } of boxes.slice(i + 1)) {
          if (one.contains(other)) continue;
          const wide = Math.min(box.right, at.right) - Math.max(box.left, at.left);
          const high = Math.min(box.bottom, at.bottom) - Math.max(box.top, at.top);
          if (wide > 1 && high > 1) wrong.push(`${name(one)} and ${name(other)} lie over one another`);
        }
        if (one.tagName === 'BUTTON' && one.scrollWidth > one.clientWidth + 1) wrong.push(`${name(one)} is cut`);
      }
      const edge = panel.getBoundingClientRect().right;
      const leaves = [...panel.querySelectorAll('*')].filter((one) => one.childElementCount === 0 && isShown(one) && !one.closest('.scroll, svg'));
      for (const leaf of leaves) if (leaf.getBoundingClientRect().right > edge + 1) wrong.push(`${name(leaf)} sticks out of its card`);
    }
    return wrong;
  });

// Whatever stands beside it: all chips, and a way to log out.
const fillHeader = (page) =>
  page.evaluate(() => {
    for (const [id, words] of [['arm-chip', 'arm: console-12736-1'], ['goal-chip', 'goal 12: cancelled'], ['log-out', 'Log out']]) {
      document.getElementById(id).hidden = false;
      document.getElementById(id).textContent = words;
    }
    document.getElementById('state').textContent = 'no connection: the board refuses this page, and says why at some length';
  });

for (const [index, { name, width, height, touch }] of screens.entries()) {
  const context = await browser.newContext({ viewport: { width, height }, hasTouch: touch, isMobile: touch });
  const page = await openPage({ newPage: () => context.newPage() }, next);
  await page.waitForSelector('body[data-state=live]');
  if (index === 0) {
    await page.waitForFunction(() => /the camera is closed/.test(document.querySelector('figcaption').textContent));
    expect(true, 'where no image comes the page says why');
  }
  await page.click('#tab-eyes');
  await page.click('#eyes button:text-is("Connect")');
  await page.waitForFunction(() => document.querySelector('figure canvas').dataset.frame);
  for (const tab of await page.locator('[role=tab]:visible').allInnerTexts()) {
    await page.click(`[role=tab]:text-is("${tab}")`);
    await page.screenshot({ path: join(pictures, `${name}-${tab.toLowerCase()}.png`), fullPage: touch });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(wide <= 0, `${name}, ${tab}: nothing scrolls sideways`);
    const wrong = await awkward(page);
    expect(wrong.length === 0, `${name}, ${tab}: every control can be reached ${wrong.join('; ')}`);
    const crowds = await crowded(page);
    expect(crowds.length === 0, `${name}, ${tab}: nothing is cut, or lies over another ${crowds.join('; ')}`);
    const stop = await page.locator('#stop').boundingBox();
    expect(stop && stop.y >= 0 && stop.y + stop.height <= height && stop.height >= 40, `${name}, ${tab}: STOP is there, and big`);
  }
  await expectAccessible(page, scratch, name);

  if (touch) {
    const driving = new Driving(page);
    await driving.begin();
    await driving.driven('Ready', '(ready)');
    const finger = await context.newCDPSession(page);
    const button = page.locator(jogs('up'));
    for (let attempt = 0; ; ++attempt) {
      await button.scrollIntoViewIfNeeded();
      const box = await button.boundingBox();
      const touchPoints = [{ x: box.x + box.width / 2, y: box.y + box.height / 2 }];
      await finger.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints });
      await page.waitForFunction(
        () => window.newest('(jog up)').answer || /arm\s*moving\s*\(jog/.test(document.getElementById('readings').innerText),
      );
      await finger.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
      const { answer } = await driving.answered('(jog up)');
      if (answer === 'true') break;
      // A machine that is busy elsewhere.
      if (attempt === 20) throw new Error(`the page was never quick enough to jog: ${answer}`);
    }
    expect(true, `${name}: a finger holds a jog, and ends it`);
    await page.screenshot({ path: join(pictures, `${name}-in-hand.png`) });

    await page.click('#stop');
    await page.waitForSelector('#stopped:not([hidden])');
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    const note = await page.locator('#stopped').boundingBox();
    expect(note && note.y >= 0 && note.y + note.height <= height, `${name}: that it is stopped is in view, wherever the page is`);
    await page.click('#clear-stops');
    await page.click('#confirm button[value=yes]');
    await page.waitForSelector('#stopped', { state: 'hidden' });
  }
  const before = await page.locator('#stop').boundingBox();
  await fillHeader(page);
  const after = await page.locator('#stop').boundingBox();
  expect(before.x === after.x && before.y === after.y, `${name}: STOP stays where it is, whatever stands beside it`);
  expect(after.x + after.width >= width - 40, `${name}: at the right`);
  expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
  await context.close();
  next = await served.next(index + 1);
}

expect((await served.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
