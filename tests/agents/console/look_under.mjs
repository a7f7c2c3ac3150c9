// node look_under.mjs PIZARRA-CELL SCRATCH: what goes on on the board, live; agents with contracts, load and restarts;
// what the method of the thesis says of the running cell.

import { join } from 'node:path';
import { begin, expect, expectAccessible, source, tall, text } from './browser.mjs';

const [cell, scratch] = process.argv.slice(2);
const { page, picture, end } = await begin(scratch, [cell, 'up', join(source, 'examples/01-blocks/cell.scm'), '--console']);

// From opening the view to its rows: the quickest of some, as the machine may be busy elsewhere.
const opened = () =>
  page.evaluate(
    () =>
      new Promise((done) => {
        const rows = document.querySelector('#relations tbody');
        rows.replaceChildren();
        const began = performance.now();
        const seen = new MutationObserver(() => {
          seen.disconnect();
          done(performance.now() - began);
        });
        seen.observe(rows, { childList: true });
        document.getElementById('tab-facts').click();
      }),
  );
let quickest = Infinity;
for (let i = 0; i < 5; ++i) {
  await page.click('#tab-story');
  await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
  quickest = Math.min(quickest, await opened());
}
expect(quickest < 400, `the relations stand ${quickest.toFixed(0)} ms after their view was opened`);
await page.waitForFunction(() => /revision \d+, \d+ facts, [\d.]+ transactions\/s; a fact is committed after/.test(document.getElementById('activity-note').textContent));
const row = (name) => page.locator(`#relations tr:has(button:text-is("${name}"))`);
await row('arm-joints').waitFor();
const cells = await row('arm-joints').locator('td').allInnerTexts();
expect(cells[1] === '1' && Number(cells[3]) >= 1 && cells[6] === 'robot', `facts, watches, tellers of a relation: ${cells}`);
// Told anew every second.
await page.waitForFunction(() => [...document.querySelectorAll('#relations tr')].some((one) => /^host\s.*\d+ \/ \d+/s.test(one.innerText)));
expect(true, 'how long its facts are under way');
await row('arm-joints').locator('button').click();
await page.waitForFunction(() => document.getElementById('query-count').textContent === '1 answer');
expect((await page.inputValue('#query')) === '(arm-joints ?robot ?joints)', 'a relation is asked for by its name');
await page.locator('#facts').evaluate((panel) => panel.scrollTo(0, 0));
await picture('relations', page, tall);
await expectAccessible(page, scratch, 'the relations');

await page.click('#tab-agents');
const agent = page.locator('#agents [data-agent=vision]');
await agent.waitFor();
await page.waitForFunction(() => /told\/s, \d+ waiting, \d+ queued, 0 restarts/.test(document.querySelector('[data-agent=vision]').innerText));
await agent.locator('summary').click();
expect(/\(offers .*\(learn .*\(posts .*\(reads /s.test(await agent.locator('pre').innerText()), 'its contract, whole');
expect(true, 'how busy an agent is, and how often it was started again');
const [own] = await page.locator('#agents [data-agent^=console-]').all();
expect(/^this page/.test(await own.innerText()), 'the page itself is called so');
await page.click('#agents summary:has-text("Processes")');
const process_ = page.locator('#processes tr:has-text("vision")');
const pid = Number((await process_.innerText()).match(/started as process (\d+)/)[1]);
process.kill(pid, 'SIGKILL');
await page.waitForFunction(() => /\b1 restart\b/.test(document.querySelector('[data-agent=vision]')?.innerText ?? ''));
expect(/started as process/.test(await process_.innerText()), 'an agent that dies is seen to be started again');

await page.click('#agents summary:has-text("The method")');
await page.click('#method-look');
await page.waitForSelector('#indices');
expect(/I_cpx \d\.\d+, I_struct \d\.\d+, I_cnx \d\.\d+/.test(await text(page, '#indices')), `Divide: ${await text(page, '#indices')}`);
expect((await page.locator('.graph .component').count()) >= 5, 'the components as a picture');
const shownNames = await page.locator('.graph text').allTextContents();
expect(shownNames.includes('this page') && !shownNames.some((name) => /console-\d/.test(name)), `each by a name that a person understands: ${shownNames.join(', ')}`);
const wrapped = await page.locator('#wrappers tr:has-text("CRS")').innerText();
expect(/robot\s+a device\s+\d+\s+.*17\/182 = 0\.093/s.test(wrapped), `Wrap: ${wrapped}`);
expect((await page.locator('#connections tbody tr').count()) >= 1, `Connect: ${await page.locator('#connections tbody tr >> nth=0').innerText()}`);
const faults = await page.locator('#method').innerText();
expect(!/(this|console) page( \d+)? (watches|told)/.test(faults), `the page keeps its own contract: ${faults.match(/page( \d+)? (watches|told).*/)?.[0]}`);
await page.setViewportSize(tall);
await page.evaluate(() => document.getElementById('indices').scrollIntoView({ block: 'start' }));
await picture('method');
await expectAccessible(page, scratch, 'the method');
await end();
