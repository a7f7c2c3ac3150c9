// node lost_line.mjs PIZARRA-CELL SCRATCH: a line that falls silent in mid-jog, and then brings at once what was stuck on
// it: the arm stops by itself, and does not move for what comes late. A page that is there without that line sees it.

import { join } from 'node:path';
import { expect, here, launch, openPage, ownFolder, start } from './browser.mjs';
import { distance, Driving, jogs, Onlooker } from './driving.mjs';
import { losingLine } from './losing_line.mjs';

const [cell, scratch] = process.argv.slice(2);
const folder = ownFolder();
const served = start([cell, 'console', join(here, 'unattended.scm')], folder);
const address = await served.line;
const { port } = new URL(address);

const line = await losingLine(Number(port));
const { lose, restore } = line;

const browser = await launch(scratch, [`--host-resolver-rules=MAP 127.0.0.1:${port} 127.0.0.1:${line.port}`]);
const page = await openPage(browser, address);
await page.waitForSelector('body[data-state=live]');
expect(line.count() > 0, 'the page comes by the line that will be lost');
const driving = new Driving(page);
await driving.begin();
expect((await driving.driven('Ready', '(ready)')) === 'true', 'READY');

const direct = await launch(scratch);
const witness = await openPage(direct, await served.next(1));
await witness.waitForSelector('body[data-state=live]');
const onlooker = new Onlooker(witness);

// A machine that is busy elsewhere may be too late by itself: then once more.
let way = 'left';
async function moving() {
  for (let attempt = 0; attempt < 30; ++attempt) {
    way = way === 'left' ? 'right' : 'left';
    await page.hover(jogs(way));
    await page.mouse.down();
    await onlooker.seen(`arm\\s*moving\\s*\\(jog ${way}|arm\\s*stopped\\s*\\(jog ${way}`);
    const begun = await page.evaluate((told) => window.newest(told).answer === null, `(jog ${way})`);
    if (begun) return;
    await page.mouse.up();
  }
  throw new Error('the page was never quick enough to jog');
}
await moving();
lose();
const at = await onlooker.place();
await onlooker.seen('arm\\s*stopped');
const stood = await onlooker.place();
// What is shown may be a tenth of a second old, and rounded.
expect(distance(at, stood) <= 15, `the arm stands by itself, ${distance(at, stood).toFixed(0)} mm further`);

// The page goes on holding, unheard, and says it all at once when the line is back.
await page.evaluate(() => new Promise((later) => setTimeout(later, 1500)));
restore();
const { answer } = await driving.answered(`(jog ${way})`);
expect(/has not renewed its hold/.test(answer), `the operator is told why: ${answer}`);
await page.mouse.up();
// A question whose answer comes after all that was stuck.
await driving.standing();
const after = await onlooker.place();
expect(distance(stood, after) <= 1, 'nothing moves for what comes late');
expect(/arm\s*stopped/.test(await onlooker.readings()), 'and the arm stands as it was stopped');

// The page is not shown as live, and a STOP that nobody acknowledges is said to be none.
lose();
await page.waitForSelector('body[data-state=silent]');
expect(/silent for \d+ s/.test(await page.innerText('#state')), 'a line that falls silent is said to be silent');
const looks = () =>
  page.evaluate(() => ({
    jogs: document.querySelectorAll('.jog:not(:disabled)').length,
    reason: document.querySelector('.jog').title,
    inert: ['want', 'eyes', 'drive', 'head'].every((id) => document.getElementById(id).inert),
    old: !document.getElementById('line-note').hidden && getComputedStyle(document.getElementById('images')).filter !== 'none',
  }));
const silent = await looks();
expect(silent.jogs === 0 && /no live line/.test(silent.reason) && silent.inert, 'nothing moves the arm then, and the page says why');
expect(silent.old, 'what is shown is shown as old');
expect(!/your hands/.test(await page.innerText('#arm-chip')), 'and nobody is said to have the arm');
await page.keyboard.press('Escape');
await page.waitForSelector('#stop-alarm[role=alert]:not([hidden])');
expect(/STOP is not confirmed/.test(await page.innerText('#stop-alarm')), 'a STOP that is not acknowledged is said to be none');
expect(await witness.isHidden('#stopped'), 'which it is');
restore();
await page.waitForSelector('body[data-state=live]');
await witness.waitForSelector('#stopped:not([hidden])');
await page.waitForSelector('#stop-alarm', { state: 'hidden' });
expect(true, 'it stops when the line is back, and the alarm ends');
await page.click('#clear-stops');
await page.click('#confirm button[value=yes]');
await witness.waitForSelector('#stopped', { state: 'hidden' });

// A line that ends for good: what stands under the page goes with it.
await moving();
line.cut();
await onlooker.seen('arm\\s*stopped');
await witness.waitForSelector('#arm-chip', { state: 'hidden' });
expect(true, 'a connection that ends stops the arm, and lets it go');
await page.waitForFunction(() => document.getElementById('hands-note').innerText.includes('You no longer have the arm in hand'));
expect((await page.getAttribute('body', 'data-state')) === 'live', 'the page that comes back is told that it has the arm no more');
expect(await page.isHidden('#line-note'), 'what it shows is new');

for (const each of [page, witness]) expect(each.troubles.length === 0, `nothing went wrong: ${each.troubles.join('; ')}`);
line.end();
for (const each of [browser, direct]) await each.close();
expect((await served.end()) === 0, 'it ends in order');
process.exit(0);
