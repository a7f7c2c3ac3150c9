// node teaching.mjs PIZARRA-CELL SCRATCH: an object taught by a click: training, the learned parameters, a name, a
// second sample, a click on a frame that has gone by, and what is refused with its reason.

import { join } from 'node:path';
import { begin, expect, taught, taughtCell, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, picture, end } = await begin(scratch, [cell, 'console', taughtCell(cell)]);
await taught(page);
await page.click('#tab-eyes');
const objects = () => page.locator('.objects li strong').allInnerTexts();
await page.waitForFunction(() => document.querySelectorAll('.objects li').length >= 4);
const isListed = (name, listed) =>
  page.waitForFunction(
    ([named, expected]) => [...document.querySelectorAll('.objects strong')].some((one) => one.textContent === named) === expected,
    [name, listed],
  );
// What the person taught is forgotten, and taught again by hand.
const find = (name) => page.click(`.objects li:has(strong:text-is("${name}")) button:text("Find")`);
await find('square');
await page.waitForFunction(() => /FIND "square" OK/.test(document.getElementById('eyes-answer').textContent));
const [x, y] = (await text(page, '#eyes-answer')).match(/\(([\d.]+), ([\d.]+)\)/).slice(1).map(Number);
await page.click('.objects li:has(strong:text-is("square")) button:text("Forget")');
await isListed('square', false);

const camera = page.locator('figure canvas >> nth=0');
// Of a pixel, in the element that shows the image.
const placeOf = (px, py) =>
  camera.evaluate((canvas, [cx, cy]) => {
    const box = canvas.getBoundingClientRect();
    const scale = Math.min(box.width / canvas.width, box.height / canvas.height);
    return {
      x: (box.width - scale * canvas.width) / 2 + scale * cx,
      y: (box.height - scale * canvas.height) / 2 + scale * cy,
    };
  }, [px, py]);
const clickAt = async (px, py) => camera.click({ position: await placeOf(px, py) });
const hint = (words) =>
  page.waitForFunction((said) => document.getElementById('teach-hint').textContent.includes(said), words);
await page.waitForFunction(() => /frame \d/.test(document.querySelector('figcaption').textContent));
await clickAt(x, y);
expect(/Switch training on/.test(await text(page, '#teach-hint')), 'without training a click learns nothing');
await page.click('#training');
expect((await text(page, '#training')) === 'Training: on', 'training is on');
// What the eyes show of it, frame by frame, around that place: how much is red, and whether the rest is grey.
await page.evaluate(([cx, cy]) => {
  const canvas = document.querySelectorAll('figure canvas')[1];
  window.isFull = () => canvas.width >= 320;
  window.shown = [];
  new MutationObserver(() => {
    if (!window.isFull()) return;
    const scale = canvas.width / 320;
    const reach = 40;
    const { data } = canvas.getContext('2d').getImageData(cx * scale - reach, cy * scale - reach, 2 * reach, 2 * reach);
    const seen = { red: 0, green: 0, grey: 0 };
    for (let i = 0; i < data.length; i += 4) {
      const [r, g, b] = data.subarray(i, i + 3);
      if (r > 140 && r - g > 70 && r - b > 70) ++seen.red;
      else if (g - r > 60 && g - b > 60) ++seen.green;
      else if (Math.max(r, g, b) - Math.min(r, g, b) < 12) ++seen.grey;
    }
    window.shown.push({ ...seen, learning: document.body.dataset.eyes === 'learning' });
  }).observe(canvas, { attributes: true, attributeFilter: ['data-frame'] });
}, [x, y]);
const unnamed = 'not named yet';
const reject = async () => {
  await page.click('#reject');
  await hint('Rejected');
  await isListed(unnamed, false);
};
// A page that was busy for a moment is sent light pictures for some seconds, in which a border is hardly to be seen.
const learn = async () => {
  await page.waitForFunction(() => window.isFull());
  await page.evaluate(() => (window.shown = []));
  await clickAt(x, y);
  await page.waitForSelector('#learned-window:not([hidden]) dl');
  // The images may come later than the answer does. They end with one that shows no learning any more.
  await page.waitForFunction((until) => {
    const wasFilled = window.shown.some(({ red }) => red > 0);
    return performance.now() > until || (wasFilled && window.shown.at(-1).red + window.shown.at(-1).green === 0);
  }, 5000 + (await page.evaluate(() => performance.now())));
  return page.evaluate(() => window.shown);
};
const redsOf = (shown) => shown.map(({ red }) => red).filter((red) => red > 0);
const grows = (reds) => reds.length >= 2 && reds.at(-1) > reds[0] * 1.5;
const hasBorder = (shown) => shown.some(({ green }) => green > 20);
// The fill takes a second, and the border is shown in one frame. A browser that stands still then shows it another time.
let shown = await learn();
for (let again = 0; again < 9 && !(grows(redsOf(shown)) && hasBorder(shown)); ++again) {
  await reject();
  shown = await learn();
}
expect(grows(redsOf(shown)), `the fill is seen to grow: ${redsOf(shown).join(' ')} red pixels`);
expect(hasBorder(shown), 'and then the border');
const filling = shown.filter(({ red }) => red > 0);
expect(filling.every(({ grey, red }) => grey > (6400 - red) * 0.6), 'the rest is grey meanwhile');
const table = await text(page, '#learned-window dl');
expect((await objects()).includes(unnamed), 'it has no name in the list, and not one of the page either');
expect(/Area/.test(table) && /Perimeter/.test(table) && /NF/.test(table) && /M2/.test(table), 'Table C.1 is shown before it is named');
await picture('learned');
await reject();
expect(await page.isHidden('#learned-window'), 'what is rejected is asked about no more');
expect(!(await objects()).includes('square'), 'and is not known');
await clickAt(x, y);
await page.waitForSelector('#learned-window:not([hidden]) dl');
const accept = (name) => page.fill('#new-name', name).then(() => page.click('#learned-window button:text("Accept")'));
for (const name of ['<img src=x onerror=alert(1)>', 'two words', '"q\'', '\u202eabc \u05d0', '']) {
  await accept(name);
  const wrong = await page.$eval('#new-name', (field) => field.validationMessage);
  expect(wrong !== '' && (await page.isVisible('#learned-window')), `it is asked again for what is no name: ${name}: ${wrong}`);
}
// As much of it as a name may have.
const long = 'x'.repeat(64);
await accept('x'.repeat(200));
await hint(`${long} is accepted`);
await isListed(long, true);
expect(await page.$eval('#eyes', (panel) => panel.scrollWidth <= panel.clientWidth), 'a name of 64 letters fits into the view');
await page.click(`.objects li:has(strong:text-is("${long}")) button:text("Forget")`);
await isListed(long, false);

await clickAt(x, y);
await page.waitForSelector('#learned-window:not([hidden]) dl');
await page.fill('#new-name', 'square');
await page.click('#learned-window button:text("Accept")');
await hint('square is accepted');
await isListed('square', true);
expect(!(await objects()).includes(unnamed), 'it is known under its name');

await page.fill('#learn-name', 'square');
await clickAt(x, y);
await page.waitForSelector('#learned-window:not([hidden]) dl');
// Accepted, and clicked again before the eyes have answered, while its name still stands in the field.
const meanwhile = await camera.evaluate((canvas, at) => {
  document.querySelector('#learned-window form').requestSubmit();
  const box = canvas.getBoundingClientRect();
  canvas.dispatchEvent(new MouseEvent('click', { clientX: box.left + at.x, clientY: box.top + at.y, bubbles: true }));
  return document.getElementById('teach-hint').textContent;
}, await placeOf(x, y));
expect(/^Accepting square/.test(meanwhile), `a click while one is accepted is not taken: ${meanwhile}`);
await hint('square is accepted');
await page.waitForFunction(() => /square 2 samples/.test(document.querySelector('.objects').innerText));
expect(true, 'a second sample under the same name');

await clickAt(x, y);
await hint('FAIL');
expect(/like one that is learned/.test(await text(page, '#teach-hint')), 'what looks like another is refused in words');
await clickAt(4, 4);
await page.waitForFunction(() => /FAIL.*(background|ground)/.test(document.getElementById('teach-hint').textContent));
expect(true, 'the ground is nothing to learn');

await page.click('#training');
await clickAt(4, 4);
expect(/Switch training on/.test(await text(page, '#teach-hint')), 'with training off again a click learns nothing');

await page.click('.objects li:has(strong:text-is("square")) button:text("Track")');
await page.waitForFunction(() => /TRACK/.test(document.querySelector('[aria-label="What TRACK says"]').textContent));
await page.waitForSelector('#training:disabled');
expect(true, 'tracking excludes learning');
expect(/^you track, which excludes learning/.test(await page.getAttribute('#training', 'title')), 'and the button says why');
await picture('tracking');
await page.click('#eyes button:text-is("End track")');
await page.waitForSelector('#training:not(:disabled)');

await page.click('#tab-head');
expect(await page.isDisabled('#head button:text-is("Reset both")'), 'a cell without a head shows its controls off');
await end();
