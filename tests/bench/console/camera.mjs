// node camera.mjs SCRATCH FOLDER: a camera whose pictures carry their number in their pixels, ten a second, as a stream
// over HTTP. Writes FOLDER/cell.scm, a cell with that camera and a simulated arm, and adds to FOLDER/sent a line
// `NUMBER MICROSECONDS` for each picture, when it leaves. Says `ready`.

import { appendFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { launch } from '../../agents/console/browser.mjs';
import { numbers, readable } from './coded.mjs';

const [scratch, folder] = process.argv.slice(2);
const period = 100;

// As large as a camera's: a picture with much in it.
const browser = await launch(scratch);
const studio = await browser.newPage();
await studio.evaluate(`window.code = ${readable.draw}`);
const pictures = await studio.evaluate((count) => {
  const canvas = document.createElement('canvas');
  Object.assign(canvas, { width: 320, height: 240 });
  const pen = canvas.getContext('2d');
  for (let i = 0; i < 400; ++i) {
    pen.fillStyle = `hsl(${(i * 47) % 360} 40% ${20 + ((i * 31) % 60)}%)`;
    pen.fillRect((i * 73) % 320, (i * 41) % 240, 30, 22);
  }
  return Array.from({ length: count }, (_, number) => {
    window.code(pen, number);
    return canvas.toDataURL('image/jpeg', 0.85).split(',')[1];
  });
}, numbers);
await browser.close();
const jpegs = pictures.map((text) => Buffer.from(text, 'base64'));

const camera = createServer((_, answer) => {
  answer.writeHead(200, { 'Content-Type': 'multipart/x-mixed-replace; boundary=frame' });
  let number = 0;
  const sending = setInterval(() => {
    const jpeg = jpegs[(number = (number + 1) % numbers)];
    appendFileSync(join(folder, 'sent'), `${number} ${Date.now()}\n`);
    answer.write(`--frame\r\nContent-Type: image/jpeg\r\nContent-Length: ${jpeg.length}\r\n\r\n`);
    answer.write(jpeg);
    answer.write('\r\n');
  }, period);
  answer.on('close', () => clearInterval(sending));
});
await new Promise((listens) => camera.listen(0, '127.0.0.1', listens));
writeFileSync(
  join(folder, 'cell.scm'),
  `(cell measured
  (world)
  (arm crs-f3)
  (camera (single (stream "http://127.0.0.1:${camera.address().port}/")))
  (host "localhost" (agents robot vision)))
`,
);
console.log('ready');
