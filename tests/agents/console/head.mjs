// node head.mjs PIZARRA-CELL SCRATCH: the head that the cameras stand on: slides, places, speeds, resets, its light, and to
// look where the image is clicked.

import { join } from 'node:path';
import { begin, expect, here, tall, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, picture, end } = await begin(scratch, [cell, 'console', join(here, 'head_alone.scm')]);
await page.click('#tab-eyes');
await page.click('#eyes button:text-is("Connect")');
await page.click('#tab-head');
await page.waitForFunction(() => document.getElementById('head-light').textContent === 'ready');
expect(true, 'the light says that the head is ready');

const looks = async () => (await text(page, '#head output[aria-label="Where the head looks"]')).match(/pan (-?[\d.]+)°, tilt (-?[\d.]+)°, (\w+)/).slice(1);
const stands = (pan, tilt) =>
  page.waitForFunction(
    ([p, t]) => {
      const [, at, up] = document.querySelector('#head output').textContent.match(/pan (-?[\d.]+)°, tilt (-?[\d.]+)°, still/) ?? [];
      return Math.abs(at - p) < 0.3 && Math.abs(up - t) < 0.3;
    },
    [pan, tilt],
  );
const logged = (command) =>
  page.waitForFunction(
    (told) => [...document.querySelectorAll('#head .log li')].some((item) => item.innerText.includes(told)),
    command,
  );
const slideOf = (label) => page.locator(`input[aria-label="${label}"]`);
async function pull(slide, part) {
  const box = await slide.boundingBox();
  const at = Number(await slide.evaluate((input) => (input.value - input.min) / (input.max - input.min)));
  await page.mouse.move(box.x + 8 + (box.width - 16) * at, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 8 + (box.width - 16) * part, box.y + box.height / 2, { steps: 4 });
  const shown = await slide.evaluate((input) => [Number(input.value), input.nextSibling.textContent]);
  await page.mouse.up();
  return shown;
}

for (const axis of ['Pan', 'Tilt']) {
  const [percent] = await pull(slideOf(`${axis} speed`), 0.9);
  await logged(`(set-${axis.toLowerCase()}-speed ${percent})`);
}
expect(true, 'a speed for each axis');

await page.fill('#pan-place', '10');
await page.click('#head form:has(#pan-place) button:text-is("Move to")');
await page.fill('#tilt-place', '-5');
await page.click('#head form:has(#tilt-place) button:text-is("Move to")');
await stands(10, -5);
expect(true, 'places to move to');

const [pan, said] = await pull(slideOf('Pan left / right'), 0.3);
expect(pan < 0 && said === `${pan} °`, 'a slide shows its value while it is held');
expect((await slideOf('Pan left / right').inputValue()) === '0', 'and springs back');
await stands(10 + pan, -5);
const [tilt] = await pull(slideOf('Tilt down / up'), 0.6);
await stands(10 + pan, -5 + tilt);
expect(true, 'and turns the head by what it showed');

await page.click('#head button:text-is("Look ahead")');
await logged('(look-ahead)');
await page.waitForFunction(() => /still$/.test(document.querySelector('#head output').textContent));

// A click to the right of the middle turns it to the right, and upwards where it is above.
const camera = page.locator('figure canvas >> nth=0');
await page.waitForFunction(() => document.querySelector('figure canvas').dataset.frame);
const clickAt = async (fx, fy) => {
  const box = await camera.boundingBox();
  await camera.click({ position: { x: box.width * fx, y: box.height * fy } });
};
const entries = () => page.locator('#head .log li').count();
const before = await entries();
await clickAt(0.6, 0.4);
expect((await entries()) === before, 'a click turns nothing before it is asked to');
await page.check('#click-to-look');
const [pan0, tilt0] = (await looks()).map(Number);
await clickAt(0.6, 0.4);
await page.waitForFunction(
  ([p, t]) => {
    const [, at, up] = document.querySelector('#head output').textContent.match(/pan (-?[\d.]+)°, tilt (-?[\d.]+)°, still/) ?? [];
    return at > p + 1 && up > t + 1;
  },
  [pan0, tilt0],
);
expect(true, 'the head looks where the image is clicked');
await picture('head', page, tall);

for (const [button, command] of [
  ['Reset pan', '(reset-pan)'],
  ['Reset tilt', '(reset-tilt)'],
  ['Reset both', '(reset-all)'],
]) {
  await page.click(`#head button:text-is("${button}")`);
  await logged(command);
  await page.waitForFunction(() => document.getElementById('head-light').textContent === 'ready');
}
await stands(0, 0);
expect(true, 'three resets');
await page.click('#head button:text-is("Disconnect")');
await page.waitForFunction(() => /^closed/.test(document.getElementById('head-light').textContent));
expect(/bad/.test(await page.getAttribute('#head-light', 'class')), 'the light says that it is closed');
await page.click('#head button:text-is("Connect")');
await page.waitForFunction(() => document.getElementById('head-light').textContent === 'ready');
await end();
