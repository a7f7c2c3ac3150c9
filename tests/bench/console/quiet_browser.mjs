// Chromium asked for nothing but to evaluate. Playwright has each frame of each WebSocket handed to it, so that the bench
// would measure that: 450 images a second keep node's collector busy on all cores.
//
//   const browser = await launchQuiet(folder);                   // with `idle`: only where nobody else wants a core
//   const page = await browser.open(address);                    // a browser's session of its own
//   await page.evaluate((a, b) => a + b, 1, 2);                  // JSON in and out; promises are waited for
//   await page.until(() => document.body.dataset.state === 'live');
//   await browser.close();

import { spawn } from 'node:child_process';
import { mkdtempSync } from 'node:fs';
import { join } from 'node:path';
import { chromiumFlags, yieldingChromium } from '../../agents/console/browser.mjs';

const size = { width: 1280, height: 800, deviceScaleFactor: 1, mobile: false };
const never = 180_000; // ms: what is waited for does not come
export const idle = ['chrt', '--idle', '0'];

// Messages on a pipe, a zero byte behind each.
class Protocol {
  #into;
  #next = 1;
  #waiting = new Map();

  constructor(into, from) {
    this.#into = into;
    let rest = '';
    from.setEncoding('utf8');
    from.on('data', (data) => {
      const messages = (rest + data).split('\0');
      rest = messages.pop();
      messages.forEach((message) => this.#hear(JSON.parse(message)));
    });
    from.on('close', () => {
      for (const { reject } of this.#waiting.values()) reject(new Error('chromium has gone'));
    });
  }
  #hear({ id, result, error }) {
    const asked = this.#waiting.get(id);
    this.#waiting.delete(id);
    if (error) asked?.reject(new Error(error.message));
    else asked?.resolve(result);
  }
  send(method, params = {}, sessionId = undefined) {
    const id = this.#next++;
    this.#into.write(`${JSON.stringify({ id, method, params, sessionId })}\0`);
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }
}

class QuietPage {
  #protocol;
  #target;
  #session;

  constructor(protocol, target, session) {
    this.#protocol = protocol;
    this.#target = target;
    this.#session = session;
  }
  async evaluate(run, ...given) {
    const expression = `(${run})(...${JSON.stringify(given)})`;
    const asked = { expression, awaitPromise: true, returnByValue: true };
    const { result, exceptionDetails } = await this.#protocol.send('Runtime.evaluate', asked, this.#session);
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }
  // Looks in each frame that is drawn.
  async until(holds, ...given) {
    const came = await this.evaluate(
      `async (...given) => {
        for (const end = Date.now() + ${never}; Date.now() < end; await new Promise(requestAnimationFrame)) {
          if ((${holds})(...given)) return true;
        }
        return false;
      }`,
      ...given,
    );
    if (!came) throw new Error(`it never came: ${holds}`);
  }
  // As soon as it is there and enabled; of several, the one with that label.
  click(selector, label = null) {
    const press = (of, labelled) => {
      const isIt = ({ disabled, textContent }) => !disabled && (labelled === null || textContent === labelled);
      const found = [...document.querySelectorAll(of)].find(isIt);
      found?.click();
      return Boolean(found);
    };
    return this.until(press, selector, label);
  }
  show(address) {
    return this.#protocol.send('Page.navigate', { url: address }, this.#session);
  }
  toFront() {
    return this.#protocol.send('Target.activateTarget', { targetId: this.#target });
  }
}

// What it writes is in `folder`, whose owner removes that: chromium writes until its very end, which comes with that of
// the pipe.
export async function launchQuiet(folder, under = []) {
  const profile = mkdtempSync(join(folder, 'chromium-'));
  const flags = [...chromiumFlags, '--headless', '--remote-debugging-pipe', `--user-data-dir=${profile}`];
  const [program, ...words] = [...under, yieldingChromium, ...flags, 'about:blank'];
  const child = spawn(program, words, { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const ended = new Promise((resolve) => child.on('exit', resolve));
  const protocol = new Protocol(child.stdio[3], child.stdio[4]);
  const open = async (address) => {
    const { browserContextId } = await protocol.send('Target.createBrowserContext');
    const { targetId } = await protocol.send('Target.createTarget', { url: 'about:blank', browserContextId });
    const { sessionId } = await protocol.send('Target.attachToTarget', { targetId, flatten: true });
    await protocol.send('Emulation.setDeviceMetricsOverride', size, sessionId);
    const page = new QuietPage(protocol, targetId, sessionId);
    await page.show(address);
    return page;
  };
  const close = async () => {
    await protocol.send('Browser.close');
    await ended;
  };
  return { open, close };
}
