// node tutorial.mjs PIZARRA-CELL SCRATCH: docs/console-tutorial.md, played sentence by sentence by the mouse alone: what it
// says is done and seen, in its order, and it says nothing that is not played.

import { mkdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, launch, openPage, ownFolder, source, start, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const browser = await launch(scratch);
const folder = ownFolder();
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });

// The words between the first step's heading and what follows the last: without headings, code, pictures and marks of
// lists.
const tutorial = readFileSync(join(source, 'docs/console-tutorial.md'), 'utf8');
let unplayed = tutorial
  .slice(tutorial.indexOf('## 1.'), tutorial.indexOf('## Where next'))
  .replace(/```[^]*?```/g, '')
  .replace(/^(#.*|!\[.*)$/gm, '')
  .replace(/^(\d+\.|-) /gm, '')
  .replace(/\s+/g, ' ')
  .trim();
async function play(words, act = () => {}) {
  if (!unplayed.startsWith(words)) throw new Error(`the page goes on otherwise: ${unplayed.slice(0, 120)}`);
  await act();
  unplayed = unplayed.slice(words.length).trim();
  console.log(`ok: ${words}`);
}

const served = start([cell, 'console'], folder);
const begun = Date.now();
let page;
const tab = (name) => page.click(`[role=tab]:text-is("${name}")`);
const listed = (count) =>
  page.waitForFunction((wanted) => document.querySelectorAll('.objects li').length === wanted, count);
const row = (name, label) => page.locator(`.objects li:has(strong:text-is("${name}")) button:text-is("${label}")`);
const hint = (words) =>
  page.waitForFunction((said) => document.getElementById('teach-hint').textContent.includes(said), words);
const readings = (pattern) =>
  page.waitForFunction((words) => new RegExp(words).test(document.getElementById('readings').innerText), pattern);
const camera = () => page.locator('figure canvas >> nth=0');

await play('Open that address.', async () => {
  page = await openPage(browser, await served.line);
  await page.waitForSelector('body[data-state=live]');
});
await play(
  'The arm stands in 3D, the images come, and the scripted person of the demo cell teaches the objects: wait until the arm is at rest and *Eyes* lists five names.',
  async () => {
    await readings('grip\\s*[-\\d]+');
    await page.waitForFunction(() => [...document.querySelectorAll('figcaption')].every((one) => /frame \d/.test(one.textContent)));
    await tab('Eyes');
    await listed(5);
    await readings('arm\\s*idle');
  },
);
await play('The red **STOP**, or Escape, stops the arm at any time.', async () =>
  expect(await page.isVisible('#stop'), 'STOP is there'),
);

// Where the marks are a person sees; here FIND says it.
const marks = {};
await play('Choose *Eyes*.', () => tab('Eyes'));
for (const name of ['end-effector', 'circle', 'triangle', 'square', 'cross']) {
  await row(name, 'Find').click();
  await page.waitForFunction(
    (wanted) => document.getElementById('eyes-answer').textContent.startsWith(`(FIND "${wanted}" OK`),
    name,
  );
  marks[name] = (await text(page, '#eyes-answer')).match(/\(([\d.]+), ([\d.]+)\)/).slice(1).map(Number);
}
const clickOn = async ([px, py]) => {
  const position = await camera().evaluate(
    (canvas, [cx, cy]) => {
      const box = canvas.getBoundingClientRect();
      const scale = Math.min(box.width / canvas.width, box.height / canvas.height);
      return { x: (box.width - scale * canvas.width) / 2 + scale * cx, y: (box.height - scale * canvas.height) / 2 + scale * cy };
    },
    [px, py],
  );
  await camera().click({ position });
};
await play('Press *Forget* beside every object: the eyes know nothing.', async () => {
  for (const name of Object.keys(marks)) {
    await row(name, 'Forget').click();
    await row(name, 'Forget').waitFor({ state: 'detached' });
  }
  await listed(0);
});
await play('Press *Training: off*; it says *on*.', async () => {
  await page.click('button:text-is("Training: off")');
  await page.waitForSelector('button:text-is("Training: on")');
});
await play('The end-effector comes first.', () => hint('Begin with the end-effector'));
await play("Click on the white triangle on the gripper in the camera's image, on the left.", () =>
  clickOn(marks['end-effector']),
);
await play('In the image beside it the mark is filled red, and then gets its border.', () => hint('Learned.'));
await play('The window shows what was learned, as `end-effector`.', async () => {
  await page.waitForSelector('#learned-window:not([hidden]) dl');
  expect((await page.inputValue('#new-name')) === 'end-effector', 'it has that name');
});
const accept = async (name) => {
  await page.click('#learned-window button:text-is("Accept")');
  await hint(`${name} is accepted`);
};
await play('Press *Accept*.', () => accept('end-effector'));
const press = (name) => page.click(`#learned-window button:text-is("${name}")`);
const learn = async (name) => {
  await clickOn(marks[name]);
  await page.waitForSelector('#learned-window:not([hidden]) dl');
  await press(name);
  await accept(name);
};
await play('Click on the circle.', () => clickOn(marks.circle));
await play('Press *circle* in the window, and then *Accept*.', async () => {
  await page.waitForSelector('#learned-window:not([hidden]) dl');
  await press('circle');
  await accept('circle');
});
await play('Do the same with the triangle, the square and the cross.', async () => {
  for (const name of ['triangle', 'square', 'cross']) await learn(name);
  await listed(5);
});
await play('Click on the table: LEARN refuses it and says why.', async () => {
  await clickOn([4, 4]);
  await hint('FAIL');
});
await play('*Reject* takes back an object that was learned wrong; *Forget* does so later.', async () =>
  expect((await page.locator('.objects button:text-is("Forget")').count()) === 5, 'Forget is beside each'),
);

await play('Choose *Drive* and press *Take the arm in hand*.', async () => {
  await tab('Drive');
  await page.click('button:text-is("Take the arm in hand")');
});
await play('From now on only you move it.', () => page.waitForSelector('#drive :text("Only you move the arm now.")'));
const newest = () => text(page, '#drive .log li >> nth=0');
await play('Hold *Left* or *Up*: the arm moves while you hold, and stops when you let go.', async () => {
  await page.waitForSelector('.jog[data-jog=left]:not(:disabled)');
  for (const [label, back] of [['Up', 'Down'], ['Left', 'Right']]) {
    // On a busy machine the arm may find its operator silent: then once more, there or back.
    for (let attempt = 0; ; ++attempt) {
      const way = attempt % 2 ? back : label;
      await page.hover(`[aria-label="Jog: ${way}"]`);
      await page.mouse.down();
      await page.waitForFunction(() => {
        const [entry] = document.querySelectorAll('#drive .log li');
        return /arm\s*moving\s*\(jog/.test(document.getElementById('readings').innerText) || !/…$/.test(entry.innerText);
      });
      await page.mouse.up();
      await page.waitForFunction(() => !/…$/.test(document.querySelector('#drive .log li').innerText));
      if (/ true$/.test(await newest())) break;
      if (attempt === 20) throw new Error(`the page was never quick enough to jog: ${await newest()}`);
    }
    await readings('arm\\s*idle');
  }
});
await play('Pull the slide *Turn left / right* and let it go: the arm turns by what the slide showed.', async () => {
  const slide = page.locator('input[aria-label="Turn left / right"]');
  await slide.scrollIntoViewIfNeeded();
  const box = await slide.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.55, box.y + box.height / 2, { steps: 4 });
  const degrees = await slide.inputValue();
  await page.mouse.up();
  await page.waitForFunction(
    (told) => document.querySelector('#drive .log li').innerText.endsWith(`(turn right ${told}) true`),
    degrees,
  );
});
await play('Press *Ready*, and then *Let the arm go*: a goal needs it.', async () => {
  await page.click('#drive button:text-is("Ready")');
  await page.waitForFunction(() => /\(ready\) true$/.test(document.querySelector('#drive .log li').innerText));
  await page.click('button:text-is("Let the arm go")');
  await page.waitForSelector('#arm-chip', { state: 'hidden' });
});

await play('Press *Sketch* beside the goal.', () => page.click('button:text-is("Sketch")'));
const middle = async (name) => {
  const box = await page.locator(`[data-block=${name}]`).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};
await play('Drag `triangle` onto `square`, and `circle` onto the tower.', async () => {
  await page.waitForFunction(() => document.querySelectorAll('[data-block]').length === 4);
  for (const [name, onto] of [['triangle', 'square'], ['circle', 'triangle']]) {
    await page.mouse.move(...(await middle(name)));
    await page.mouse.down();
    await page.mouse.move(...(await middle(onto)), { steps: 5 });
    await page.mouse.up();
  }
  await page.screenshot({ path: join(pictures, 'tutorial-sketch.png') });
});
await play('Press *Go*.', () => page.click('#goal-form button:text-is("Go")'));
await play(
  "The plan appears with the operation in hand, the servo's errors go to zero before each grasp, and *Story* tells what happens.",
  async () => {
    await page.waitForSelector('#plan li.running');
    await tab('Story');
    await page.waitForSelector('#story .timeline details');
  },
);
await play('Open an entry: it says who told it, and what was seen then.', async () => {
  await page.click('#story .timeline summary >> nth=0');
  await page.waitForSelector('#story .timeline details[open] :text("told by")');
  await page.waitForSelector('#story .timeline details[open] .kept canvas');
});
await play('*Why this, now?* asks the coordinator.', async () => {
  await page.click('button:text-is("Why this, now?")');
  await page.waitForFunction(() => document.querySelector('#story pre.answer').textContent.length > 20);
});
await play(
  'When the goal is reached the line below it says so, and the tower stands in 3D and in the images.',
  () => page.waitForFunction(() => /reached/.test(document.getElementById('goal-answer').textContent)),
);
expect(unplayed === '', `nothing of the page is left: ${unplayed}`);
console.log(`played in ${((Date.now() - begun) / 60_000).toFixed(1)} minutes`);
await page.screenshot({ path: join(pictures, 'tutorial.png') });
expect(page.troubles.length === 0, `nothing went wrong: ${page.troubles.join('; ')}`);
expect((await served.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
