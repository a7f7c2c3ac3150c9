// node sketched_goal.mjs PIZARRA-CELL SCRATCH: a goal by the mouse alone: towers sketched by dragging, and pursued.

import { begin, expect, taught, taughtCell } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, picture, end } = await begin(scratch, [cell, 'console', taughtCell(cell)]);
await taught(page);
await page.click('#sketch-toggle');
await page.waitForFunction(() => document.querySelectorAll('[data-block]').length >= 4);
const block = (name) => page.locator(`[data-block=${name}]`);
const middle = async (name) => {
  const box = await block(name).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};
const drag = async (name, to) => {
  await page.mouse.move(...(await middle(name)));
  await page.mouse.down();
  await page.mouse.move(...(await to()), { steps: 5 });
  await page.mouse.up();
};
const goal = () => page.inputValue('#goal-text');
expect((await block('end-effector').count()) === 0, 'the gripper is no block');
await drag('triangle', () => middle('square'));
expect((await goal()) === '(on triangle square)', 'a block dragged onto another');
await drag('circle', () => middle('square'));
const both = ['(on triangle square)', '(on circle triangle)'];
const tower = await goal();
expect(
  both.every((fact) => tower.includes(fact)),
  `on top of what is there: ${tower}`,
);
await page.click('#tab-eyes');
await picture('sketch');
await drag('circle', async () => {
  const box = await page.locator('.towers').boundingBox();
  return [box.x + box.width - 6, box.y + 12];
});
expect((await goal()) === '(on triangle square)', 'and back to the table');
await block('circle').click();
await block('triangle').click();
expect((await goal()).includes('(on circle triangle)'), 'by two clicks, too');
await page.click('#goal-form button[type=submit]');
await page.waitForSelector('#plan li.running');
expect(await page.isHidden('#sketch'), 'the plan takes its place');
await end();
