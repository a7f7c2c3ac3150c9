// What the browser's tests stand on: chromium, a console, and words for what is expected. What cannot be had is said,
// and the test is skipped (status 77).

import { spawn, spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

export const chromium = '/usr/bin/chromium';
const here = dirname(fileURLToPath(import.meta.url));
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

// The folder whose node_modules are what the lock file says: the page's own, or one made below `scratch`.
export function modulesFolder(scratch) {
  if (existsSync(join(pageFolder, 'node_modules/playwright-core'))) return pageFolder;
  const folder = join(scratch, 'console-page');
  if (existsSync(join(folder, 'node_modules/playwright-core'))) return folder;
  mkdirSync(folder, { recursive: true });
  for (const file of ['package.json', 'package-lock.json']) copyFileSync(join(pageFolder, file), join(folder, file));
  const made = spawnSync('npm', ['ci', '--ignore-scripts', '--no-audit', '--no-fund'], {
    cwd: folder,
    encoding: 'utf8',
  });
  if (made.status !== 0) skip(`npm ci gives no playwright-core: ${made.stderr ?? made.error}`.slice(0, 400));
  return folder;
}

export async function launch(scratch) {
  if (!existsSync(chromium)) skip(`there is no ${chromium}: Debian's package chromium`);
  const { chromium: driver } = createRequire(join(modulesFolder(scratch), 'x.js'))('playwright-core');
  return driver.launch({
    executablePath: chromium,
    headless: true,
    // Three dimensions without a graphics card: by SwiftShader.
    args: [
      '--no-sandbox',
      '--disable-gpu',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
    ],
  });
}

// A folder in which programs find no other cell and leave none.
export function ownFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'pizarra-console-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

// A program that runs until the test ends it; `line` is the first that it says,
// `ended` its status.
export function start(words, folder) {
  const child = spawn(words[0], words.slice(1), { env: { ...process.env, XDG_RUNTIME_DIR: folder, TMPDIR: folder } });
  let said = '';
  const addresses = [];
  const line = new Promise((resolveLine, reject) => {
    child.stdout.on('data', (data) => {
      said += data;
      if (words[1] === 'up') addresses.push(...(String(data).match(/http:\/\/\S+#\w+/g) ?? []));
      if (said.includes('\n')) resolveLine(said.split('\n')[0]);
    });
    child.stderr.on('data', (data) => {
      process.stderr.write(data);
      addresses.push(...(String(data).match(/http:\/\/\S+#\w+/g) ?? []));
    });
    child.on('exit', (code) => reject(new Error(`${words.join(' ')} ended with ${code}: ${said}`)));
  });
  line.catch(() => {});
  const ended = new Promise((resolveEnd) => child.on('exit', (code) => resolveEnd(code)));
  process.on('exit', () => child.kill('SIGKILL'));
  const end = () => {
    child.kill('SIGINT');
    return ended;
  };
  // The address for the browser that comes after so many.
  const next = async (count) => {
    while (addresses.length < count) await new Promise((later) => setTimeout(later, 20));
    return addresses[count - 1];
  };
  return { line, next, end, ended };
}

export function say(words, folder) {
  const done = spawnSync(words[0], words.slice(1), {
    env: { ...process.env, XDG_RUNTIME_DIR: folder },
    encoding: 'utf8',
  });
  if (done.status !== 0)
    throw new Error(`${words.join(' ').slice(0, 300)}: ${done.status} ${done.stdout}${done.stderr}`);
}

// A page that counts what a page of ours must never do.
export async function openPage(browser, address, size = { width: 1280, height: 800 }) {
  const page = await browser.newPage({ viewport: size });
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

export const text = (page, selector) => page.locator(selector).innerText();

export async function ask(page, question) {
  await page.click('#tab-facts');
  await page.fill('#query', question);
  await page.press('#query', 'Enter');
}
