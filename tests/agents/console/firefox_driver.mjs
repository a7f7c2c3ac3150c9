// Firefox by WebDriver BiDi, as far as a test of the console needs it: one page, what is evaluated in it, keys and clicks,
// pictures. Debian's own firefox-esr speaks it; no driver of others stands between.

import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { modulesFolder, skip } from './browser.mjs';

const firefox = '/usr/bin/firefox-esr';
// What is waited for comes sooner or later; this long means that it does not.
const never = 300_000;

class Bidi {
  #socket;
  #next = 1;
  #waiting = new Map();
  troubles = [];

  constructor(socket) {
    this.#socket = socket;
    socket.on('message', (data) => this.#hear(JSON.parse(data)));
    socket.on('close', () => {
      for (const { reject } of this.#waiting.values()) reject(new Error('firefox has gone'));
    });
  }
  #hear(message) {
    if (message.type === 'event') {
      const { level, text } = message.params;
      if (level === 'error') this.troubles.push(text);
      return;
    }
    const { resolve, reject } = this.#waiting.get(message.id);
    this.#waiting.delete(message.id);
    if (message.type === 'success') resolve(message.result);
    else reject(new Error(`${message.error}: ${message.message}`));
  }
  send(method, params) {
    const id = this.#next++;
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, { resolve, reject });
      this.#socket.send(JSON.stringify({ id, method, params }));
    });
  }
}

export class FirefoxPage {
  #bidi;
  #context;
  constructor(bidi, context) {
    this.#bidi = bidi;
    this.#context = context;
  }
  get troubles() {
    return this.#bidi.troubles;
  }

  // The value of a JSON-able expression in the page.
  async evaluate(expression) {
    const said = await this.#bidi.send('script.evaluate', {
      expression: `JSON.stringify(${expression})`,
      target: { context: this.#context },
      awaitPromise: true,
    });
    if (said.type === 'exception') throw new Error(`${expression}: ${said.exceptionDetails.text}`);
    return said.result.type === 'string' ? JSON.parse(said.result.value) : undefined;
  }
  async until(expression) {
    const end = Date.now() + never;
    while (!(await this.evaluate(`Boolean(${expression})`))) {
      if (Date.now() > end) throw new Error(`it never came: ${expression}`);
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
  }
  text(selector) {
    return this.evaluate(`document.querySelector(${JSON.stringify(selector)}).innerText`);
  }
  #act(source) {
    return this.#bidi.send('input.performActions', { context: this.#context, actions: [source] });
  }
  // By the pointer, into the middle of what is scrolled there.
  async click(selector) {
    const quoted = JSON.stringify(selector);
    await this.until(`document.querySelector(${quoted})?.disabled === false || document.querySelector(${quoted})?.matches(':not(:disabled)')`);
    const { x, y } = await this.evaluate(`(() => {
      const shown = document.querySelector(${quoted});
      shown.scrollIntoView({ block: 'nearest' });
      const box = shown.getBoundingClientRect();
      return { x: Math.round(box.x + box.width / 2), y: Math.round(box.y + box.height / 2) };
    })()`);
    await this.#act({
      type: 'pointer',
      id: 'mouse',
      actions: [
        { type: 'pointerMove', x, y },
        { type: 'pointerDown', button: 0 },
        { type: 'pointerUp', button: 0 },
      ],
    });
  }
  press(...keys) {
    const actions = keys.flatMap((value) => [{ type: 'keyDown', value }, { type: 'keyUp', value }]);
    return this.#act({ type: 'key', id: 'keys', actions });
  }
  // Typed into a field that is empty.
  async type(selector, written) {
    await this.evaluate(`(document.querySelector(${JSON.stringify(selector)}).value = '')`);
    await this.click(selector);
    await this.press(...written);
  }
  async picture(file) {
    const { data } = await this.#bidi.send('browsingContext.captureScreenshot', { context: this.#context });
    writeFileSync(file, Buffer.from(data, 'base64'));
  }
}

// Where its BiDi listens, or why it does not.
function listening(child) {
  return new Promise((resolve, reject) => {
    let said = '';
    child.stderr.on('data', (data) => {
      said += data;
      const found = said.match(/WebDriver BiDi listening on (ws:\/\/\S+)/);
      if (found) resolve(found[1]);
    });
    child.on('error', reject);
    child.on('exit', (status) => reject(new Error(`firefox ended with ${status}: ${said.slice(-600)}`)));
  });
}

// A page of its own firefox at that address; `end` ends both.
export async function openFirefox(scratch, size) {
  if (!existsSync(firefox)) skip(`there is no ${firefox}: Debian's package firefox-esr`);
  const { WebSocket } = createRequire(join(modulesFolder(scratch), 'x.js'))('ws');
  const profile = mkdtempSync(join(tmpdir(), 'pizarra-firefox-'));
  // Nothing is asked of anybody's server.
  const settings = {
    'app.update.enabled': false,
    'browser.shell.checkDefaultBrowser': false,
    'datareporting.policy.dataSubmissionEnabled': false,
    'network.captive-portal-service.enabled': false,
    'network.connectivity-service.enabled': false,
    'toolkit.telemetry.enabled': false,
  };
  const lines = Object.entries(settings).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${value});`);
  writeFileSync(join(profile, 'user.js'), lines.join('\n'));
  const child = spawn(
    firefox,
    ['--headless', '--no-remote', '--profile', profile, '--remote-debugging-port', '0', `--width=${size.width}`, `--height=${size.height}`],
    { env: { ...process.env, HOME: profile, MOZ_DISABLE_CONTENT_SANDBOX: '1' } },
  );
  const ended = new Promise((resolve) => child.on('exit', resolve));
  process.on('exit', () => {
    child.kill('SIGKILL');
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  });
  const address = await listening(child);
  const socket = new WebSocket(`${address}/session`);
  await new Promise((resolve, reject) => socket.on('open', resolve).on('error', reject));
  const bidi = new Bidi(socket);
  const { capabilities } = await bidi.send('session.new', { capabilities: {} });
  await bidi.send('session.subscribe', { events: ['log.entryAdded'] });
  const { context } = await bidi.send('browsingContext.create', { type: 'tab' });
  await bidi.send('browsingContext.setViewport', { context, viewport: size });
  return {
    version: capabilities.browserVersion,
    page: new FirefoxPage(bidi, context),
    go: (url) => bidi.send('browsingContext.navigate', { context, url, wait: 'complete' }),
    end: async () => {
      child.kill('SIGTERM');
      await ended;
    },
  };
}
