// node pictures.mjs FOLDER: writes FOLDER/cell.scm, a cell with a simulated arm and a camera whose pictures are
// files that carry their number in their pixels.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { draw, numbers } from './coded.mjs';
import { launchQuiet } from './quiet_browser.mjs';

const [folder] = process.argv.slice(2);
const browser = await launchQuiet(folder);
const studio = await browser.open('about:blank');
// Sharp edges at low contrast: as many bytes as the simulated camera gives, and nothing to be taken for a mark.
const pictures = await studio.evaluate(
  (count, drawing) => {
    const canvas = document.createElement('canvas');
    Object.assign(canvas, { width: 320, height: 240 });
    const pen = canvas.getContext('2d');
    const code = new Function(`return ${drawing}`)();
    for (let i = 0; i < 60; ++i) {
      pen.fillStyle = `hsl(${(i * 47) % 360} 30% ${55 + ((i * 31) % 12)}%)`;
      pen.fillRect((i * 73) % 320, (i * 41) % 240, 30, 22);
    }
    return Array.from({ length: count }, (_, number) => {
      code(pen, number);
      return canvas.toDataURL('image/jpeg', 0.85).split(',')[1];
    });
  },
  numbers,
  draw.toString(),
);
await browser.close();

mkdirSync(join(folder, 'pictures'));
pictures.forEach((text, number) => {
  const name = `${String(number).padStart(4, '0')}.jpg`;
  writeFileSync(join(folder, 'pictures', name), Buffer.from(text, 'base64'));
});
writeFileSync(
  join(folder, 'cell.scm'),
  `(cell measured
  (world)
  (arm crs-f3)
  (camera (single (images "pictures")))
  (host "localhost" (agents robot vision)))
`,
);
