// node drive.mjs PIZARRA-CELL SCRATCH: the thesis' first subsystem in the Drive view: slides, poses, places by name,
// actions typed, the questions, and the robot's service taken and given back.

import { join } from 'node:path';
import { begin, expect, expectAccessible, here, tall, text } from './browser.mjs';
import { distance, Driving } from './driving.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, picture, end } = await begin(scratch, [cell, 'console', join(here, 'unattended.scm')]);
const driving = new Driving(page);
await page.click('#tab-eyes');
await page.click('#eyes button:text-is("Connect")');
await driving.begin();
const done = async (label, command, what) => {
  const answer = await driving.driven(label, command);
  expect(answer === 'true', `${what}: ${answer}`);
};
await done('Ready', '(ready)', 'READY');

// Every slide shows its value while it is held, springs back, and tells what it showed once it is let go.
const slides = {
  'Retract / extend': ['mm', (v) => (v > 0 ? `(extend keep-height ${v})` : `(retract ${-v})`)],
  'Turn left / right': ['°', (v) => `(turn ${v > 0 ? 'right' : 'left'} ${Math.abs(v)})`],
  'Move left / right': ['mm', (v) => `(move-h ${v > 0 ? 'right' : 'left'} ${Math.abs(v)})`],
  'Move down / up': ['mm', (v) => `(move-v ${v > 0 ? 'up' : 'down'} ${Math.abs(v)})`],
  'Tool down / up': ['°', (v) => `(turn-ef ${v > 0 ? 'up' : 'down'} ${Math.abs(v)})`],
  'Wrist left / right': ['°', (v) => `(turn-wrist ${v > 0 ? 'right' : 'left'} ${Math.abs(v)})`],
};
const slideOf = (label) => page.locator(`input[aria-label="${label}"]`);
const shown = (slide) => slide.evaluate((input) => [Number(input.value), input.nextSibling.textContent]);
// `part` of the slide's length, from its left end.
async function hold(slide, part) {
  await slide.scrollIntoViewIfNeeded();
  const box = await slide.boundingBox();
  const at = Number(await slide.evaluate((input) => (input.value - input.min) / (input.max - input.min)));
  await page.mouse.move(box.x + 8 + (box.width - 16) * at, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 8 + (box.width - 16) * part, box.y + box.height / 2, { steps: 4 });
}
for (const [label, [unit, form]] of Object.entries(slides)) {
  // There and back, so that the arm stays where every slide can move it.
  for (const part of [0.6, 0.4]) {
    const slide = slideOf(label);
    await hold(slide, part);
    const [value, said] = await shown(slide);
    expect(value !== 0 && value > 0 === part > 0.5 && said === `${value} ${unit}`, `${label} shows ${said} while it is held`);
    await page.mouse.up();
    expect((await shown(slide))[1] === `0 ${unit}`, 'and springs back');
    const { told, answer } = await driving.answered(form(value));
    expect(answer === 'true', `${told} ${answer}`);
  }
}

const commands = () => page.locator('#drive .log li').count();
const before = await commands();
await hold(slideOf('Move down / up'), 0.8);
await slideOf('Move down / up').dispatchEvent('pointercancel');
await page.mouse.up();
expect((await commands()) === before, 'a slide whose pointer is taken away tells nothing');
await slideOf('Move down / up').focus();
for (let i = 0; i < 3; ++i) await page.keyboard.down('ArrowRight');
expect((await shown(slideOf('Move down / up')))[0] === 3, 'a key that is held pulls a slide');
expect((await commands()) === before, 'and tells nothing before it is up');
await page.keyboard.up('ArrowRight');
expect((await driving.answered('(move-v up 3)')).answer === 'true', 'and then once');

await hold(slideOf('Speed'), 0.3);
const [percent] = await shown(slideOf('Speed'));
await page.mouse.up();
expect((await driving.answered(`(speed ${percent})`)).answer === 'true', 'SPEED');
expect((await shown(slideOf('Speed')))[0] === percent, `the speed's slide stays at ${percent} %`);
await hold(slideOf('Gripper opening'), 0.3);
const [opening] = await shown(slideOf('Gripper opening'));
await page.mouse.up();
expect((await driving.answered(`(gripper ${opening})`)).answer === 'true', `the gripper opens ${opening} mm`);
await page.waitForFunction((mm) => new RegExp(`gripper\\s*${mm} mm`).test(document.getElementById('readings').innerText), opening);
await hold(slideOf('Gripper close / open'), 0.7);
const [more] = await shown(slideOf('Gripper close / open'));
await page.mouse.up();
expect(more > 0 && (await shown(slideOf('Gripper close / open')))[0] === 0, 'the gripper has a spring slide, too');
expect((await driving.answered(`(gripper ${opening + more})`)).answer === 'true', `which opens it by ${more} mm more`);

await page.fill('#variable', 'p1');
await done('Save', '(learn p1)', 'SAVE');
const saved = await driving.standing();
await page.waitForSelector('#variables option[value=p1]', { state: 'attached' });
expect(true, 'the name is offered from then on');
await done('Home', '(home)', 'HOME');
expect(distance(saved, await driving.standing()) > 50, 'it is elsewhere');
await done('Go to', '(goto p1)', 'GOTO');
expect(distance(saved, await driving.standing()) <= 2, 'it is where it was saved');
await page.fill('#variable', 'Not a name');
await driving.press('Go to');
expect(await page.evaluate(() => !document.getElementById('variable').checkValidity()), 'what is no name is refused');
const target = [saved[0], saved[1], saved[2] + 30].map(Math.round);
await page.fill('#action', `(move ${target.join(' ')})`);
await done('Do action', '(do-action', 'an action typed');
expect(distance(target, await driving.standing()) <= 2, 'it is where the action says');
await page.fill('#action', 'CIRCLE p1, p2, p3');
const none = await driving.driven('Do action', '(do-action');
expect(/p2/.test(none), `the arm says why an action is none: ${none}`);

expect(!/-0(?![\d.])/.test(await text(page, '#readings')), 'no number is a negative zero');
const monitored = (await driving.driven('Monitor', '(monitor)')).split(' ').map(Number);
await page.waitForFunction(
  (joints) => {
    const told = document.querySelector('#drive .axes').textContent.matchAll(/[a-z]+\s(-?[\d.]+)\s(?:°|mm)/g);
    const axes = [...told].map((each) => Number(each[1]));
    return axes.length === joints.length && axes.every((value, i) => Math.abs(value - joints[i]) < 0.2);
  },
  monitored.slice(6),
);
expect(monitored.length === 13, 'MONITOR: place, turns and seven axes, which the page shows as they are');
const axes = await text(page, '#drive .axes');
expect(/^turn\s[-\d.]+\s° .* track\s[-\d.]+\smm$/.test(axes), `by name and unit: ${axes}`);
expect(/joints\s+(-?\d+ +){5}-?\d+ °\s+\d+ mm/.test(await text(page, '#readings')), 'also in the corner of the picture');
await done('Finish: report', '(finish report)', 'FINISH report');
expect(/do-action/.test(await driving.driven('Status', '(get-status)')), 'the last action');

// A motion that is under way for long enough to be asked about, and ended.
const setSpeed = async (part) => {
  await hold(slideOf('Speed'), part);
  const [set] = await shown(slideOf('Speed'));
  await page.mouse.up();
  await driving.answered(`(speed ${set})`);
};
await setSpeed(0.02);
await hold(slideOf('Turn left / right'), 0.9);
const [degrees] = await shown(slideOf('Turn left / right'));
await page.mouse.up();
await page.waitForFunction(() => /arm\s*moving/.test(document.getElementById('readings').innerText));
expect((await driving.driven('Finish: report', '(finish report)')) === 'false', 'FINISH reports a motion that goes on');
await done('Finish: stop', '(finish stop)', 'FINISH stop');
expect(/stopped/.test((await driving.answered(`(turn right ${degrees})`)).answer), 'the motion is stopped');
await setSpeed(0.9);

await done('Release control', '(release-control)', 'the service is stopped');
await page.waitForFunction(() => /released control/.test(document.getElementById('service-light').textContent));
const home = page.locator('#drive button:text-is("Home")');
expect(await home.isDisabled(), 'nothing that moves is pressed then');
expect(/Slides, poses and actions: you released control/.test(await text(page, '#why-drive')), 'and the page says why');
await picture('released');
await expectAccessible(page, scratch, 'an arm whose control is released');
await done('Get control', '(get-control)', 'the service is started');
await page.waitForFunction(() => document.getElementById('service-light').textContent === 'In service');
await done('Home', '(home)', 'and moves');

const log = await text(page, '#drive .log');
for (const word of ['(release-control)', '(finish stop)', `(speed ${percent})`]) expect(log.includes(word), `the log has ${word}`);
await page.fill('#variable', 'p1');
await page.fill('#action', `(move ${target.join(' ')})`);
await page.locator('#drive').evaluate((panel) => panel.scrollTo(0, 0));
await picture('drive', page, tall);
await end();
