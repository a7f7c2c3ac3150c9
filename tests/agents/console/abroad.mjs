// node abroad.mjs PIZARRA-CELL PIZARRA-KEYS SCRATCH: the console at an address that other machines reach: by TLS alone,
// for who shows a key's token, who may do there what that key may.

import { execFileSync, spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { request } from 'node:https';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { expect, expectAccessible, launch, openPage, ownFolder, skip, start, taught, taughtCell, text } from './browser.mjs';

const [cell, keys, scratch] = process.argv.slice(2);
if (spawnSync('openssl', ['version']).status !== 0) skip('there is no openssl to make a certificate with');
const browser = await launch(scratch);
const pictures = join(scratch, 'console-screenshots');
mkdirSync(pictures, { recursive: true });
const folder = ownFolder();
const inFolder = (name) => join(folder, name);
const key = (...words) => execFileSync(keys, ['keys', ...words, '--dir', inFolder('keys')], { encoding: 'utf8' }).trim();
for (const name of ['board', 'console', 'anna']) key('new', name);
key('new', 'guest', '--tell', 'agent,contract,stop,reply', '--read', '*');
key('new', 'mute', '--tell', 'stop', '--read', '*');
const annas = key('token', 'anna');
const guests = key('token', 'guest');
const mutes = key('token', 'mute');
const subject = ['-subj', '/CN=localhost', '-addext', 'subjectAltName=DNS:localhost'];
const made = ['-keyout', inFolder('tls.key'), '-out', inFolder('tls.pem'), '-days', '2', '-nodes'];
const curve = ['-newkey', 'ec', '-pkeyopt', 'ec_paramgen_curve:prime256v1'];
execFileSync('openssl', ['req', '-x509', ...curve, ...subject, ...made], { stdio: 'ignore' });

const free = await new Promise((resolve) => {
  const probe = createServer().listen(0, '127.0.0.1', () => {
    const { port } = probe.address();
    probe.close(() => resolve(port));
  });
});
const board = `tcp://127.0.0.1:${free}`;
const cellFile = taughtCell(cell);
const described = readFileSync(cellFile, 'utf8').replace('(host "localhost"', `(board "localhost" "${board}" (keys "${inFolder('keys')}"))\n  (host "localhost"`);
writeFileSync(cellFile, described);
const up = start([cell, 'up', cellFile], folder);
await up.line;
const untilTold = async (fact, words) => {
  const ask = ['ask', '--board', board, '--key', inFolder('keys/console.secret'), fact];
  for (;;) {
    const { stdout } = spawnSync(cell, ask, { env: { ...process.env, XDG_RUNTIME_DIR: folder }, encoding: 'utf8' });
    if (stdout.includes(words)) return;
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
};
await untilTold('(agent ?n ?k ?h)', 'coordinator');
const listening = [
  cell, 'console', cellFile, '--board', board, '--key', inFolder('keys/console.secret'),
  '--listen', '127.0.0.1', '--host', 'localhost', '--keys', inFolder('keys'),
  '--certificate', inFolder('tls.pem'), '--certificate-key', inFolder('tls.key'),
];
const refused = spawnSync(listening[0], listening.slice(1, 7).concat('--listen', '0.0.0.0'), { encoding: 'utf8' });
expect(refused.status === 2 && /certificate/.test(refused.stderr), `without a certificate and tokens it does not listen there: ${refused.stderr.trim().slice(0, 120)}`);
for (const odd of ['', 'localhost', '1.2.3', '127.0.0.1:80', '[::1]']) {
  const { status, stderr } = spawnSync(cell, ['console', '--listen', odd], { encoding: 'utf8' });
  expect(status === 2 && /is no IP address/.test(stderr), `nor at what is no address: ${stderr.trim().slice(0, 120)}`);
}
const byFile = ['console', '--cell', 'blocks', ...listening.slice(5)];
const unchecked = spawnSync(cell, byFile, { env: { ...process.env, XDG_RUNTIME_DIR: folder }, encoding: 'utf8', timeout: 30_000 });
expect(unchecked.status === 2 && /must ask for keys.*--board/s.test(unchecked.stderr), `nor where the board asks for no keys: ${unchecked.stderr.trim().slice(0, 200)}`);
const served = start(listening, folder);
const address = await served.line;
expect(/^https:\/\/localhost:\d+\/$/.test(address), `the address says no secret: ${address}`);
await untilTold('(console-address console ?address)', `"${address}"`);
expect(true, "the board knows it, so that a hall's page leads there");

const { port } = new URL(address);
const status = (headers) =>
  new Promise((resolve) => {
    const call = request({ host: '127.0.0.1', port, headers, rejectUnauthorized: false }, (answer) => resolve(answer.statusCode));
    call.on('error', (error) => resolve(error.code));
    call.end();
  });
expect((await status({ Host: `localhost:${port}` })) === 200, 'the page is there for anybody who calls it by its name');
expect((await status({ Host: `127.0.0.1:${port}` })) === 421, 'a name that is not its own is refused');
const plain = await fetch(`http://localhost:${port}/`).then(() => 'an answer', () => 'nothing');
expect(plain === 'nothing', 'without TLS nobody is answered');

async function visit() {
  const context = await browser.newContext({ ignoreHTTPSErrors: true, viewport: { width: 1280, height: 800 } });
  return openPage(context, address);
}
async function logIn(page, token) {
  await page.waitForSelector('#refused[open] #log-in');
  await page.fill('#token', token);
  await page.press('#token', 'Enter');
}
const page = await visit();
await logIn(page, `anna.${'0'.repeat(64)}`);
await page.waitForFunction(() => document.getElementById('log-in-wrong').textContent !== '');
expect(true, 'a wrong token is refused');
await page.screenshot({ path: join(pictures, 'log-in.png') });
await expectAccessible(page, scratch, 'the log-in');
await logIn(page, annas);
await page.waitForSelector('body[data-state=live]');
await page.waitForSelector('#refused', { state: 'hidden' });
const cookies = await page.context().cookies(`${address}socket`);
expect(cookies.length === 1 && cookies[0].secure && cookies[0].httpOnly, 'the cookie is for TLS alone, and for no script');
const frame = () => page.evaluate(() => Number(document.querySelector('#images figcaption').textContent.match(/frame (\d+)/)?.[1] ?? 0));
await page.waitForFunction(() => /frame \d/.test(document.querySelector('#images figcaption').textContent));
const first = await frame();
await page.waitForFunction((old) => Number(document.querySelector('#images figcaption').textContent.match(/frame (\d+)/)[1]) > old + 30, first);
expect(true, 'images go on coming');
await taught(page);
await page.fill('#goal-text', '(on circle triangle)');
await page.press('#goal-text', 'Enter');
await page.waitForSelector('#plan li.running');
expect(true, 'who may everything gives a goal');
await page.click('#tab-drive');
await page.click('#take-arm');
await page.waitForFunction(() => document.getElementById('arm-chip').textContent.includes('your hands'));

const guest = await visit();
await logIn(guest, guests);
await guest.waitForSelector('body[data-state=live]');
await guest.waitForFunction(() => /arm: anna, page \d/.test(document.getElementById('arm-chip').textContent));
expect(true, 'another sees whose hands have the arm');
// What a key has no right to is off, and says why where everybody reads it.
const off = async (tab, note, control, reason) => {
  if (tab) await guest.click(tab);
  await guest.waitForSelector(`${control}:disabled`);
  const said = await text(guest, note);
  expect(reason.test(said) && (await guest.isVisible(note)), `${control} is off: ${said}`);
  expect((await guest.getAttribute(control, 'aria-describedby')) === note.slice(1), 'and points to its reason');
};
await off('', '#why-want', '#go', /Go: your key may not give goals \(it lacks: tell request\)/);
await off('#tab-story', '#why-not-asked', '#why', /may not ask an agent to do anything \(it lacks: tell request\)/);
await off('#tab-eyes', '#why-eyes', '#training', /Training.*may not ask an agent to do anything \(it lacks: tell request\)/);
await off('#tab-drive', '#why-take', '#take-arm', /may not take the arm in hand \(it lacks: tell commander\)/);
await off('', '#why-take', '#ask-for-arm', /may not ask another for the arm \(it lacks: tell commander-wanted\)/);
await off('', '#why-drive', '.jog[data-jog=up]', /Jogs.*may not .*\(it lacks: tell/);
await off('', '#why-drive', '#drive button:text-is("Monitor")', /Questions.*may not ask an agent to do anything \(it lacks: tell request\)/);
await guest.screenshot({ path: join(pictures, 'guest.png') });
await off('#tab-head', '#why-head', '#click-to-look', /may not ask an agent to do anything \(it lacks: tell request\)/);
expect(await guest.isEnabled('#stop'), 'STOP is not');
await expectAccessible(guest, scratch, 'a page that may do little');
// Whatever a page shows, the board holds it to its key. The page disables the button again whenever it is drawn anew.
await guest.fill('#goal-text', '(on cross square)');
await guest.evaluate(() => {
  const go = document.getElementById('go');
  go.disabled = false;
  go.click();
});
await guest.waitForSelector('#goal-answer.bad');
expect(/may not|permit/.test(await text(guest, '#goal-answer')), `the board holds a guest to its key: ${await text(guest, '#goal-answer')}`);
await guest.keyboard.press('Escape');
await page.waitForSelector('#stopped:not([hidden])');
expect(/^guest, page \d/.test(await text(page, '#stopped-by')), 'and who may only tell a stop stops the arm');

const mute = await visit();
await logIn(mute, mutes);
await mute.waitForFunction(() => /your key may not open a page \(the key mute may not tell facts of agent/.test(document.getElementById('state').textContent));
expect(true, `a page that the board refuses says why: ${await text(mute, '#state')}`);

await guest.click('#log-out');
await guest.waitForSelector('#refused[open] #log-in');
expect(true, 'who logs out is out');
// So many pages of one key, however she logs in.
const ask = (path, headers, method = 'GET') =>
  new Promise((resolve) => {
    const own = { Host: `localhost:${port}`, Origin: address.slice(0, -1), ...headers };
    const call = request({ host: '127.0.0.1', port, path, method, headers: own, rejectUnauthorized: false }, (answer) => {
      let said = '';
      answer.on('data', (more) => (said += more));
      answer.on('end', () => resolve({ status: answer.statusCode, said, cookie: answer.headers['set-cookie']?.[0] }));
    });
    call.on('upgrade', (answer, socket) => resolve({ status: answer.statusCode, socket }));
    call.end();
  });
const { cookie } = await ask('/session', { Authorization: `Bearer ${annas}` }, 'POST');
const upgrade = { Connection: 'Upgrade', Upgrade: 'websocket', 'Sec-WebSocket-Version': '13', 'Sec-WebSocket-Key': btoa('0123456789abcdef') };
const more = [];
for (let i = 0; i < 8; ++i) more.push(await ask('/socket', { Cookie: cookie.split(';')[0], ...upgrade }));
expect(more.filter(({ status }) => status === 101).length === 7, 'with the one that she has open, anna opens eight pages');
expect(more[7].status === 503 && /the key anna has 8 pages open/.test(more[7].said), `and is told why no more: ${more[7].said.trim()}`);
for (const { socket } of more) socket?.destroy();

rmSync(inFolder('keys/anna.token'));
await page.waitForSelector('#refused[open] #log-in', { timeout: 5000 });
expect(/this session is over/.test(await text(page, '#log-in-wrong')), 'a token that is taken away ends the pages that are open, and says so');
await page.reload();
await page.waitForSelector('#refused[open] #log-in');
expect(true, 'and lets nobody in, nor its session');
const troubles = [page, guest, mute].flatMap((one) => one.troubles).filter((said) => !/^asked elsewhere: wss:/.test(said));
expect(troubles.length === 0, `nothing went wrong in the pages: ${troubles.join('; ')}`);
expect((await served.end()) === 0 && (await up.end()) === 0, 'it ends in order');
await browser.close();
process.exit(0);
