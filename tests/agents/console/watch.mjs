// node watch.mjs PIZARRA-CELL SCRATCH: the cell in three dimensions: reach, camera, objects as sure and as exact as they
// are seen, the way to the target, and the simulated world's truth, which only the page is shown.

import { ask, begin, expect, expectAccessible, pixelsLike, taught, taughtCell, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, picture, end } = await begin(scratch, [cell, 'console', taughtCell(cell)]);
const shows = (kind, wanted) =>
  page.waitForFunction(([of, like]) => new RegExp(like).test(document.getElementById('scene').dataset[of] ?? ''), [kind, wanted]);
const canvas = '#scene-card';
const pink = [255, 79, 216];
const blue = [108, 192, 255];
const orange = [242, 163, 58];
await shows('reach', '^true$');
await shows('camera', '^true$');
expect(true, 'how far the arm reaches, and what the camera sees');

await taught(page);
await page.fill('#goal-text', '(on circle triangle) (on triangle square)');
await page.press('#goal-text', 'Enter');
// First, since there is a target only while the goal is built.
await shows('target', '^(circle|triangle|square)$');
expect((await pixelsLike(page, canvas, orange)) > 20, 'the next target and the way to it are drawn');
await page.waitForFunction(() => (document.getElementById('beliefs').textContent.match(/\d+ %\s+±\d/g) ?? []).length >= 3);
expect(/circle\s+\d+ %\s+±\d+\.\d mm/.test(await text(page, '#beliefs')), `how sure and how exact: ${await text(page, '#beliefs')}`);
await shows('spread', '^[3-9]$');
expect((await pixelsLike(page, canvas, blue)) > 20, 'the spread of distances is drawn');

expect((await pixelsLike(page, canvas, pink)) === 0, 'no truth is shown unless it is asked for');
await page.check('#truth');
await shows('truth', '^4$');
expect(/known to no agent/.test(await text(page, '#truth-note')), 'it is marked as what it is');
expect((await pixelsLike(page, canvas, pink)) > 100, 'the truth is laid over what is believed');
await page.click('#tab-story');
await page.selectOption('#story select', { label: '10 minutes' });
await picture('truth');
await expectAccessible(page, scratch, 'the cell in three dimensions');
await page.uncheck('#truth');
await shows('truth', '^0$');
expect((await pixelsLike(page, canvas, pink)) === 0, 'and taken away again');
await ask(page, '(truth ?this)');
await page.waitForSelector('#query-wrong:not([hidden])');
expect(/no relation is called truth/.test(await text(page, '#query-wrong')), 'the board has never heard of it');
await end();
