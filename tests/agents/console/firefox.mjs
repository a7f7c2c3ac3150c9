// node firefox.mjs PIZARRA-CELL SCRATCH: the main path in firefox-esr: the cell alive, images, a goal typed and reached,
// Escape, the arm in hand, an object found.

import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { expect, ownFolder, start, taughtCell } from './browser.mjs';
import { openFirefox } from './firefox_driver.mjs';

const [cell, scratch] = process.argv.slice(2);
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const firefox = await openFirefox(scratch, { width: 1280, height: 800 });
const { page } = firefox;
console.log(`firefox ${firefox.version}`);
const served = start([cell, 'console', taughtCell(cell)], ownFolder());
await firefox.go(await served.line);
const textOf = (id) => `document.getElementById('${id}').textContent`;
await page.until("document.body.dataset.state === 'live'");
await page.until(`/mm/.test(${textOf('readings')})`);
expect((await page.evaluate('location.hash + document.cookie')) === '', 'the page is alive, its token gone, its cookie hidden');

const frame = "Number(document.querySelector('#images figcaption').textContent.match(/frame (\\d+)/)?.[1] ?? 0)";
await page.until(`${frame} > 0`);
const first = await page.evaluate(frame);
await page.until(`${frame} > ${first} + 10`);
const drawn = await page.evaluate(`(() => {
  const { data } = document.querySelector('#images canvas').getContext('2d').getImageData(0, 0, 320, 240);
  return data.some((value, i) => i % 4 < 3 && value > 100);
})()`);
expect(drawn, 'images are drawn, and go on coming');
const flat = await page.evaluate("document.getElementById('scene-note').innerText");
expect(flat === '' || /WebGL is off\). All else works/.test(flat), `the cell is drawn in three dimensions, or the page says why not: ${flat}`);

await page.click('#tab-facts');
await page.type('#query', '(person done ?objects)');
await page.press('\uE007');
await page.until(`${textOf('query-count')} === '1 answer'`);
expect(true, 'a question is answered, and its answer comes as it is told');
await page.type('#goal-text', '(on circle trianglo)');
await page.press('\uE007');
await page.until(`${textOf('goal-answer')}.includes('the nearest is triangle')`);
await page.type('#goal-text', '(on circle triangle)');
await page.press('\uE007');
await page.until("document.querySelector('#plan li.running')");
await page.picture(join(pictures, 'firefox.png'));
await page.until(`${textOf('goal-answer')}.includes('reached')`);
expect(true, 'a goal that was typed is reached');

await page.click('#tab-story');
await page.click('#story .timeline details summary');
await page.until("document.querySelector('#story .kept canvas:not([hidden])')");
expect(true, 'an entry of the story shows what was seen then');

await page.type('#goal-text', '(on cross square)');
await page.press('\uE007');
await page.until(`/moving/.test(${textOf('readings')})`);
await page.press('\uE00C');
await page.until("!document.getElementById('stopped').hidden");
await page.until(`/arm\\s*(stopped|idle)/.test(${textOf('readings')})`);
expect(true, 'Escape, from within a field, stops the arm');
await page.click('#tab-drive');
await page.click('#take-arm');
await page.until(`${textOf('arm-chip')}.includes('your hands')`);
await page.click('#clear-stops');
await page.click('#confirm button[value=yes]');
await page.until("document.getElementById('stopped').hidden");
expect(true, 'a stop is cleared by who has the arm in hand');
await page.click('#tab-eyes');
await page.click('.objects li button');
await page.until("/FIND .* (OK|FAIL)/.test(document.getElementById('eyes-answer').textContent)");
expect(true, 'an object is looked for');
const policy = page.troubles.filter((said) => /Content.Security.Policy|TrustedHTML|Error/.test(said) && !/WebGL/.test(said));
expect(policy.length === 0, `nothing went wrong in the page: ${policy.join('; ')}`);
expect((await served.end()) === 0, 'Ctrl-C ends it in order');
await page.until("document.body.dataset.state !== 'live'");
expect(true, 'the page says that the console is gone');
await firefox.end();
process.exit(0);
