// node docs_pictures.mjs SCRATCH: makes the pictures of docs/ anew, of those that the browser's tests kept below SCRATCH.
// They are WebP: all colours stay, and the files are small. A person looks at each before it is committed.

import { readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { expect, launch, source } from './browser.mjs';

const scratch = resolve(process.argv[2]);
const largest = 200_000; // bytes
const best = 0.92;
// By the test's name for it and that of the docs.
const pictures = {
  building: 'console', because: 'console-because', calibration: 'console-calibration', cells: 'console-cells', drive: 'console-drive', eyes: 'console-eyes',
  guest: 'console-guest', head: 'console-head', learned: 'console-learned', method: 'console-method', past: 'console-past', relations: 'console-relations',
  plans: 'console-plans', sketch: 'console-sketch', 'story-picture': 'console-story', 'tablet-across-in-hand': 'console-tablet', truth: 'console-truth',
};

const browser = await launch(scratch);
const page = await browser.newPage();
// As base64.
const webp = (png, quality) =>
  page.evaluate(
    async ([bytes, good]) => {
      const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], { type: 'image/png' }));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      canvas.getContext('2d').drawImage(bitmap, 0, 0);
      const made = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/webp', quality: good })).arrayBuffer());
      let text = '';
      for (const byte of made) text += String.fromCharCode(byte);
      return btoa(text);
    },
    [png, quality],
  );
for (const [from, to] of Object.entries(pictures)) {
  const png = readFileSync(join(scratch, 'console-screenshots', `${from}.png`)).toString('base64');
  let made = Buffer.alloc(0);
  for (let quality = best; made.length === 0 || made.length > largest; quality -= 0.04) {
    if (quality < 0.7) throw new Error(`${from} does not become small enough`);
    made = Buffer.from(await webp(png, quality), 'base64');
  }
  writeFileSync(join(source, 'docs', `${to}.webp`), made);
  expect(made.length <= largest, `${to}.webp: ${made.length} bytes`);
}
await browser.close();
