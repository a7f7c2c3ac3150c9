// What the browser's tests stand on: chromium, a console, and words for what is expected. What cannot be had is said,
// and the test is skipped (status 77).

import { spawn, spawnSync } from 'node:child_process';
import { copyFileSync, cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

export const chromium = '/usr/bin/chromium';
export const here = dirname(fileURLToPath(import.meta.url));
export const source = resolve(here, '../../..');
export const pageFolder = join(source, 'agents/console/page');

export function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(77);
}

export function expect(holds, what) {
  if (!holds) throw new Error(`not so: ${what}`);
  console.log(`ok: ${what}`);
}

const packages = () => Object.keys(JSON.parse(readFileSync(join(pageFolder, 'package.json'), 'utf8')).devDependencies);
const holdsPackages = (folder) => packages().every((name) => existsSync(join(folder, 'node_modules', name)));

// The folder whose node_modules are what the lock file says: the page's own, or one made below `scratch`.
export function modulesFolder(scratch) {
  if (holdsPackages(pageFolder)) return pageFolder;
  const folder = join(scratch, 'console-page');
  const lock = 'package-lock.json';
  const isCurrent = existsSync(join(folder, lock)) && readFileSync(join(folder, lock)).equals(readFileSync(join(pageFolder, lock)));
  if (isCurrent && holdsPackages(folder)) return folder;
  mkdirSync(folder, { recursive: true });
  for (const file of ['package.json', 'package-lock.json']) copyFileSync(join(pageFolder, file), join(folder, file));
  const made = spawnSync('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], {
    cwd: folder,
    encoding: 'utf8',
  });
  if (made.status !== 0) skip(`npm ci gives no packages: ${made.stderr ?? made.error}`.slice(0, 400));
  return folder;
}

// The same folder, with the page's sources beside its node_modules.
export function folderOfSources(scratch) {
  const folder = modulesFolder(scratch);
  if (folder === pageFolder) return folder;
  for (const file of ['build.mjs', 'tsconfig.json']) copyFileSync(join(pageFolder, file), join(folder, file));
  rmSync(join(folder, 'src'), { recursive: true, force: true });
  cpSync(join(pageFolder, 'src'), join(folder, 'src'), { recursive: true });
  return folder;
}

// It yields to the cell that it shows.
export const yieldingChromium = join(here, 'yielding_chromium');
export const chromiumFlags = [
  '--no-sandbox',
  // Three dimensions without a graphics card: by SwiftShader.
  '--disable-gpu',
  '--use-angle=swiftshader',
  '--enable-unsafe-swiftshader',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

export async function launch(scratch, more = []) {
  if (!existsSync(chromium)) skip(`there is no ${chromium}: Debian's package chromium`);
  const { chromium: driver } = createRequire(join(modulesFolder(scratch), 'x.js'))('playwright-core');
  return driver.launch({ executablePath: yieldingChromium, headless: true, args: [...chromiumFlags, ...more] });
}

// A folder in which programs find no other cell and leave none.
export function ownFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'pizarra-console-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

// The file of the cell of examples/01-blocks, whose eyes know its objects from the start.
export function taughtCell(cell) {
  const folder = ownFolder();
  say([join(source, 'tests/taught_cell'), cell, folder], folder);
  return join(folder, 'cell.scm');
}

// Whole lines of what a program says.
function eachLine(stream, take) {
  let rest = '';
  stream.on('data', (data) => {
    const lines = (rest + data).split('\n');
    rest = lines.pop();
    lines.forEach(take);
  });
}

// A program that runs until the test ends it, in whatever way this process ends; `line` is the first that it says, `ended` its status, `said` what it says
// behind a word of it, `next` the address for the browser that comes after so many.
export function start(words, folder) {
  const child = spawn('setpriv', ['--pdeathsig', 'TERM', ...words], { env: { ...process.env, XDG_RUNTIME_DIR: folder, TMPDIR: folder } });
  const lines = [];
  const waiting = new Set();
  const hear = (line) => {
    lines.push(line);
    for (const look of waiting) look();
  };
  const ended = new Promise((resolveEnd) => child.on('exit', (code) => resolveEnd(code)));
  const early = ended.then((code) => {
    throw new Error(`${words.join(' ')} ended with ${code}`);
  });
  early.catch(() => {});
  // What `find` makes of the lines, once that is something.
  const when = (find) =>
    Promise.race([
      early,
      new Promise((resolveFound) => {
        const look = () => {
          const found = find();
          if (found === undefined) return;
          waiting.delete(look);
          resolveFound(found);
        };
        waiting.add(look);
        look();
      }),
    ]);
  const first = new Promise((resolveLine) =>
    eachLine(child.stdout, (said) => {
      resolveLine(said);
      if (words[1] === 'up') hear(said);
    }),
  );
  const line = Promise.race([early, first]);
  line.catch(() => {});
  eachLine(child.stderr, (said) => {
    process.stderr.write(`${said}\n`);
    hear(said);
  });
  const end = () => {
    child.kill('SIGINT');
    return ended;
  };
  const next = (count) => when(() => lines.flatMap((said) => said.match(/http:\/\/\S+#\w+/g) ?? [])[count - 1]);
  const said = (pattern) => when(() => lines.map((each) => each.match(pattern)?.[1]).find(Boolean));
  return { line, next, said, end, ended };
}

export function say(words, folder) {
  const done = spawnSync(words[0], words.slice(1), {
    env: { ...process.env, XDG_RUNTIME_DIR: folder },
    encoding: 'utf8',
  });
  if (done.status !== 0)
    throw new Error(`${words.join(' ').slice(0, 300)}: ${done.status} ${done.stdout}${done.stderr}`);
}

// What is waited for comes sooner or later, also on a machine that is busy elsewhere: this long means that it does not.
const never = 180_000;

// A board that holds a story which nobody lives: what it tells of is declared, and told by `tell` or another word of the
// teller's. `options` are the board's.
export function storyBoard(board, folder, ...options) {
  if (spawnSync('/usr/bin/python3', ['-c', 'import zmq']).status !== 0)
    skip('python3-zmq is not there to tell facts with');
  const at = `ipc://${folder}/board`;
  const kept = start([board, '--listen', at, ...options], folder);
  const teller = (word) => say(['/usr/bin/python3', join(here, 'story_teller.py'), source, at, word], folder);
  teller('declare');
  return { at, tell: (word = 'tell') => teller(word), end: kept.end };
}

// For a picture of a view that is longer than the usual page.
export const tall = { width: 1280, height: 1080 };

// A page that counts what a page of ours must never do.
export async function openPage(browser, address, size = { width: 1280, height: 800 }) {
  const page = await browser.newPage({ viewport: size });
  page.setDefaultTimeout(never);
  page.troubles = [];
  page.on('dialog', (dialog) => {
    page.troubles.push(`a dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on('pageerror', (error) => page.troubles.push(`an error: ${error}`));
  page.on('console', (message) => {
    if (message.type() === 'error' && /Content Security Policy|TrustedHTML/.test(message.text()))
      page.troubles.push(message.text());
  });
  page.on('request', (request) => {
    if (!request.url().startsWith(new URL(address).origin)) page.troubles.push(`asked elsewhere: ${request.url()}`);
  });
  await page.goto(address);
  return page;
}

// The page's own connections that are opened from now on: none, unless one was lost. Those of images come and go.
export function reconnections(page) {
  const opened = [];
  page.on('websocket', (socket) => {
    if (new URL(socket.url()).pathname === '/socket') opened.push(socket.url());
  });
  return opened;
}

// Of what a page shows, in a window of another size where one is given.
export async function keepPicture(page, path, size = null) {
  const usual = page.viewportSize();
  if (size) await page.setViewportSize(size);
  await page.evaluate(() => new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn))));
  await page.screenshot({ path });
  if (size) await page.setViewportSize(usual);
}

// A program that serves a console (`console ...`, `up ... --console`) in a folder of its own, and a page of it that is
// alive. `picture` keeps what a page shows; `end` finds that nothing went wrong in the pages, and ends everything.
export async function begin(scratch, words) {
  const browser = await launch(scratch);
  const pictures = join(scratch, 'console-screenshots');
  mkdirSync(pictures, { recursive: true });
  const folder = ownFolder();
  const served = start(words, folder);
  const page = await openPage(browser, await (words[1] === 'up' ? served.next(1) : served.line));
  await page.waitForSelector('body[data-state=live]');
  const picture = (name, of = page, size = null) => keepPicture(of, join(pictures, `${name}.png`), size);
  const end = async (...others) => {
    for (const { troubles } of [page, ...others]) expect(troubles.length === 0, `nothing went wrong in a page: ${troubles.join('; ')}`);
    expect((await served.end()) === 0, 'it ends in order');
    await browser.close();
    process.exit(0);
  };
  return { browser, folder, served, page, picture, end };
}

// How many pixels of what an element shows are of that colour, or near it.
export async function pixelsLike(page, selector, colour) {
  const picture = (await page.locator(selector).screenshot()).toString('base64');
  return page.evaluate(
    async ([bytes, like]) => {
      const blob = new Blob([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], { type: 'image/png' });
      const bitmap = await createImageBitmap(blob);
      const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext('2d');
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) if (like.every((value, k) => Math.abs(data[i + k] - value) < 24)) ++count;
      return count;
    },
    [picture, colour],
  );
}

export const text = (page, selector) => page.locator(selector).innerText();

export async function ask(page, question) {
  await page.click('#tab-facts');
  await page.fill('#query', question);
  await page.press('#query', 'Enter');
}

// The person of the cell has taught its objects, with the cell's own arm.
export async function taught(page) {
  await ask(page, '(person done ?objects)');
  await page.waitForFunction(() => document.getElementById('query-count').textContent === '1 answer');
}

// axe-core finds nothing serious in what the page shows.
export async function expectAccessible(page, scratch, view) {
  const axe = readFileSync(join(modulesFolder(scratch), 'node_modules/axe-core/axe.min.js'), 'utf8');
  if (!(await page.evaluate(() => 'axe' in window))) await page.evaluate(axe);
  const { violations } = await page.evaluate(() =>
    window.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa'] }),
  );
  const bad = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
  const said = bad.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(' | ')}`);
  expect(bad.length === 0, `nothing serious in ${view} ${said.join('\n')}`);
}
