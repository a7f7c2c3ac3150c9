// node windows.mjs PIZARRA-CELL SCRATCH: the page in the windows of small laptops, and on a tablet that is held upright and
// touched: nothing sticks out sideways, no name is broken in its middle, and what is touched is large enough.

import { join } from 'node:path';
import { ask, begin, expect, here, keepPicture, openPage } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { browser, page, picture, served, end } = await begin(scratch, [cell, 'console', join(here, 'unattended.scm')]);
const views = ['story', 'eyes', 'drive', 'head', 'facts', 'agents'];

// What is not within the window, of what is shown and does not scroll by itself.
const sticksOut = (of) =>
  of.evaluate(() => {
    const out = [...document.querySelectorAll('body *')].filter((one) => {
      const { left, right, width } = one.getBoundingClientRect();
      return width > 0 && (left < -1 || right > innerWidth + 1) && !one.closest('svg, .scroll, dialog');
    });
    return out.map((one) => `${one.tagName} ${one.id} ${one.textContent.slice(0, 30)}`);
  });
// On how many lines the legend of the servo's plot stands, which is there also while nothing is plotted: its box has room
// for one. And numbers of an answer that stand on more than one.
const linesOfLegend = (of) =>
  of.$$eval('#servo-plot .u-series', (all) => new Set(all.map((one) => one.getBoundingClientRect().top).filter(Boolean)).size);
const brokenNumbers = (of) =>
  of.$$eval('#answers tbody td', (cells) => {
    const lines = (one) => {
      const range = document.createRange();
      range.selectNodeContents(one);
      return new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size;
    };
    return cells.filter((one) => /^[-.\d]+$/.test(one.textContent) && lines(one) > 1).map((one) => one.textContent);
  });
// Names of agents that stand on more than one line.
const broken = (of) =>
  of.$$eval('#agents .timeline strong', (names) => names.filter((one) => one.getClientRects()[0].height > 30).map((one) => one.textContent));

async function fits(of, where) {
  for (const view of views) {
    await of.click(`#tab-${view}`);
    await of.waitForSelector(`#${view}:not([hidden])`);
    const out = await sticksOut(of);
    expect(out.length === 0, `${where}: ${view} is within the window ${out.join(', ')}`);
  }
  await of.click('#tab-story');
  expect((await linesOfLegend(of)) === 1, `${where}: the servo's legend is whole`);
  await ask(of, '(arm-pose ?robot ?x ?y ?z ?rx ?ry ?rz)');
  await of.waitForSelector('#answers tbody td');
  const numbers = await brokenNumbers(of);
  expect(numbers.length === 0, `${where}: no number is broken ${numbers.join(', ')}`);
  await of.click('#tab-agents');
  await of.waitForFunction(() => document.querySelector('#agents [data-agent=robot] .load')?.textContent);
  const names = await broken(of);
  expect(names.length === 0, `${where}: no agent's name is broken ${names.join(', ')}`);
}
for (const [width, height] of [[1024, 768], [1366, 768]]) {
  await page.setViewportSize({ width, height });
  await fits(page, `${width} x ${height}`);
  expect(await page.evaluate(() => document.scrollingElement.scrollHeight <= innerHeight), 'all of it is in one window');
}
await page.setViewportSize({ width: 1024, height: 768 });
await picture('small-window');

const upright = { width: 768, height: 1024 };
const tablet = await openPage(await browser.newContext({ hasTouch: true, viewport: upright }), await served.next(1), upright);
await tablet.waitForSelector('body[data-state=live]');
await fits(tablet, 'a tablet');
await tablet.tap('#tab-drive');
const small = await tablet.$$eval('button, input:not([type=checkbox]), select', (all) =>
  all.filter((one) => one.checkVisibility() && one.getBoundingClientRect().height < 32).map((one) => one.id || one.textContent),
);
expect(small.length === 0, `what is touched is large enough ${small.join(', ')}`);
await tablet.tap('#take-arm');
await tablet.waitForFunction(() => document.getElementById('arm-chip').textContent.includes('your hands'));
await tablet.tap('#stop');
await page.waitForSelector('#stopped:not([hidden])');
expect(true, 'a touch takes the arm, and a touch stops it');
await keepPicture(tablet, join(scratch, 'console-screenshots', 'upright-tablet.png'));
await end(tablet);
