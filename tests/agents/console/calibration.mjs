// node calibration.mjs PIZARRA-CELL PIZARRA-BOARD SCRATCH: a chessboard is held before a camera, and the page shows what
// the calibration still lacks. The camera is a stream of this test, which shows each place until the page has seen it.

import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { expect, expectAccessible, launch, openPage, ownFolder, start, tall, text } from './browser.mjs';

const [cell, board, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });

// A browser's perspective is a camera of that focal length.
const size = { width: 480, height: 360 };
const studio = await browser.newPage({ viewport: size });
const square = 25;
const [columns, rows] = [10, 7];
await studio.setContent(`<body style="margin:0;background:#777;overflow:hidden;height:100vh;perspective:420px">
  <div id="board" style="position:absolute;left:${(size.width - columns * square) / 2}px;top:${(size.height - rows * square) / 2}px;
    width:${columns * square}px;height:${rows * square}px;border:${square}px solid #fff;margin:-${square}px;
    background:repeating-conic-gradient(#fff 0 25%,#111 0 50%) 0 0/${2 * square}px ${2 * square}px;background-clip:padding-box"></div></body>`);
async function photograph(transform) {
  await studio.locator('#board').evaluate((one, how) => {
    one.style.transform = how;
    one.hidden = how === '';
    one.style.display = how === '' ? 'none' : '';
  }, transform);
  return studio.screenshot({ type: 'jpeg', quality: 95 });
}

let shown = await photograph('');
const camera = createServer((_, answer) => {
  answer.writeHead(200, { 'Content-Type': 'multipart/x-mixed-replace; boundary=frame' });
  const sending = setInterval(() => {
    answer.write(`--frame\r\nContent-Type: image/jpeg\r\nContent-Length: ${shown.length}\r\n\r\n`);
    answer.write(shown);
    answer.write('\r\n');
  }, 100);
  answer.on('close', () => clearInterval(sending));
});
await new Promise((listens) => camera.listen(0, '127.0.0.1', listens));
const cellFile = join(folder, 'own.scm');
writeFileSync(
  cellFile,
  `(cell own (camera (single (stream "http://127.0.0.1:${camera.address().port}/"))) (host "localhost" (agents vision)))`,
);

const at = `ipc://${folder}/board`;
const kept = start([board, '--listen', at], folder);
const served = start([cell, 'console', '--board', at], folder);
const page = await openPage(browser, await served.line, tall);
await page.waitForSelector('body[data-state=live]');
await page.click('#tab-eyes');
expect(await page.isHidden('#calibration'), 'without a calibration there is nothing of one');

const result = join(folder, 'own.calibration');
const calibrate = () =>
  start([cell, 'calibrate', '--cell', cellFile, '--tell', '--board', at, '--pairs', '9', '--out', result], folder);
const shows = (id, words) =>
  page.waitForFunction(([where, said]) => document.getElementById(where).textContent.includes(said), [id, words]);
const lacks = () => text(page, '#calibration-lacks');
const fitted = calibrate();
await shows('calibration-sees', 'no board');
expect(/hold the board before the camera/.test(await lacks()), 'before a board is seen the page asks for one');

// All over the image; the first two face the camera.
const places = [-150, 0, 150].flatMap((x) => [-110, 0, 110].map((y) => [x, y]));
const turns = ['', '', 'rotateX(28deg)', 'rotateY(-28deg)', 'rotateX(-28deg)', 'rotateY(28deg)', 'rotateX(25deg) rotateY(20deg)'];
for (const [i, [x, y]] of places.entries()) {
  shown = await photograph(`translate3d(${x * 1.5}px, ${y * 1.5}px, -210px) ${turns[i % turns.length]}`);
  await shows('calibration-count', `${i + 1} of 9 boards`);
  if (i === 1) {
    expect(/tilt the board/.test(await lacks()), 'boards that all face the camera are to be tilted');
    expect(/to the bottom right of the image/.test(await lacks()), 'and brought to where none was');
    expect(!/to the top left of the image/.test(await lacks()), 'but not to where one was');
  }
  if (i === 4) await page.locator('#calibration').screenshot({ path: join(pictures, 'calibration.png') });
  if (i === 4) await expectAccessible(page, scratch, 'a calibration');
}
await shows('calibration-state', 'done');
expect((await fitted.ended) === 0 && existsSync(result), 'the calibration is made');
expect((await lacks()) === 'nothing more', 'and nothing was missing');
expect(/written; reprojection error 0\.\d+ px/.test(await text(page, '#calibration-sentence')), 'the page says how good it is');
await page.screenshot({ path: join(pictures, 'calibrated.png') });

const again = calibrate();
await shows('calibration-count', '1 of 9 boards');
expect((await again.end()) === 130, 'Ctrl-C ends it');
await shows('calibration-state', 'failed');
expect(/at least 5/.test(await text(page, '#calibration-sentence')), 'and the page says why there is no result');
expect(page.troubles.length === 0, `nothing went wrong in the page: ${page.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await kept.end();
await browser.close();
process.exit(0);
