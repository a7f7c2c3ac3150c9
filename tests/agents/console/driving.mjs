// What the tests of the Drive view stand on: what the page has the arm do, and where that stands then.

export const jogs = (direction) => `.jog[data-jog=${direction}]`;

export class Driving {
  #page;

  constructor(page) {
    this.#page = page;
  }

  // Shows the view, with the arm in hand.
  async begin() {
    const page = this.#page;
    await page.click('#tab-drive');
    // The newest entry of this page in the log that begins so; its answer is null while it is under way.
    await page.evaluate(() => {
      window.newest = (wanted) => {
        for (const item of document.querySelectorAll('#drive .log li')) {
          const [, who, told, answer] = [...item.children].map((part) => part.textContent);
          if (who === 'you ' && told.startsWith(wanted)) return { told, answer: answer === ' …' ? null : answer.trim() };
        }
        return { told: '', answer: null };
      };
    });
    await page.click('#take-arm');
    await page.waitForSelector(`${jogs('right')}:not(:disabled)`);
  }

  press(label) {
    return this.#page.click(`#drive button:text-is("${label}")`);
  }
  async answered(command) {
    await this.#page.waitForFunction((wanted) => window.newest(wanted).answer !== null, command);
    return this.#page.evaluate((wanted) => window.newest(wanted), command);
  }
  // Presses the button, and answers how what it tells the arm ended.
  async driven(label, command) {
    await this.press(label);
    return (await this.answered(command)).answer;
  }

  // Where the arm says that it is, once the page shows it: facts come after the answer for which they were told.
  async standing() {
    await this.press('Monitor');
    const { answer } = await this.answered('(monitor)');
    const at = answer.split(' ').slice(0, 3).map(Number);
    await this.#page.waitForFunction((told) => {
      const shown = document.getElementById('readings').innerText;
      const grip = shown.match(/grip\s*([-\d]+)\s+([-\d]+)\s+([-\d]+) mm/)?.slice(1);
      return /arm\s*(idle|stopped)/.test(shown) && grip?.every((value, i) => Math.abs(value - told[i]) <= 1);
    }, at);
    return at;
  }
}

export const distance = (a, b) => Math.hypot(...a.map((value, i) => value - b[i]));

// The arm as a page shows it that only looks on: what a test goes by where its own page's line fails.
export class Onlooker {
  #page;

  constructor(page) {
    this.#page = page;
  }

  readings() {
    return this.#page.locator('#readings').innerText();
  }
  // Of the grip, in mm.
  async place() {
    return (await this.readings()).match(/grip\s*([-\d]+)\s+([-\d]+)\s+([-\d]+) mm/).slice(1).map(Number);
  }
  // So many mm on from there, or it has ended.
  goneOn(from, most) {
    return this.#page.waitForFunction(
      ([x, y, far]) => {
        const shown = document.getElementById('readings').innerText;
        const [nowX, nowY] = shown.match(/grip\s*([-\d]+)\s+([-\d]+)/).slice(1).map(Number);
        return Math.hypot(nowX - x, nowY - y) >= far || !/arm\s*moving/.test(shown);
      },
      [from[0], from[1], most],
    );
  }
  seen(pattern) {
    return this.#page.waitForFunction((words) => new RegExp(words).test(document.getElementById('readings').innerText), pattern);
  }
}
