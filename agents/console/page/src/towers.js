// A goal as a sketch of towers: a block is dragged onto another, or chosen and then the one that it goes on; dragged to
// the table it stands alone again. What the sketch means is written into the goal's field.

import { clipped, element, find } from './dom.js';

const table = 'the table';
const most = 16;

export class Towers {
  /** @type {string[]} */
  #names = [];
  /** @type {Map<string, string>} */
  #below = new Map(); // a block, and what it stands on
  #chosen = '';
  #dragged = '';
  #ground = element('div', { class: 'towers', role: 'group', 'aria-label': 'Towers' });
  panel = element('div', { id: 'sketch', hidden: true });

  /** @param {(goal: string) => void} written */
  constructor(written) {
    this.written = written;
    const clear = element('button', { type: 'button', onclick: () => this.#clear() }, 'Clear');
    this.panel.append(
      this.#ground,
      element('div', { class: 'row' }, element('span', { class: 'quiet' }, 'Drag a block onto another.'), clear),
    );
    this.#ground.addEventListener('pointerup', (event) => this.#drop(event));
    this.#ground.addEventListener('pointercancel', () => (this.#dragged = ''));
  }

  /** @param {string[]} names */
  setNames(names) {
    this.#names = names.slice(0, most);
    for (const [block, below] of this.#below) {
      if (!this.#names.includes(block) || !this.#names.includes(below)) this.#below.delete(block);
    }
    this.#draw();
  }

  /** @param {string} below */
  #on(below) {
    return [...this.#below].find(([, under]) => under === below)?.[0];
  }
  // From the bottom to the top.
  /** @param {string} bottom @returns {string[]} */
  #tower(bottom) {
    const above = this.#on(bottom);
    return above ? [bottom, ...this.#tower(above)] : [bottom];
  }

  /** @param {string} block @param {string} target */
  #put(block, target) {
    this.#chosen = '';
    if (target === table) {
      this.#below.delete(block);
    } else if (block !== target && !this.#tower(block).includes(target)) {
      // On what is there already it goes on top.
      const bottom = this.#bottomOf(target);
      this.#below.delete(block);
      this.#below.set(block, this.#tower(bottom).at(-1) ?? bottom);
    }
    this.#draw();
    this.written(this.#names.flatMap((name) => (this.#below.has(name) ? [`(on ${name} ${this.#below.get(name)})`] : [])).join(' '));
  }
  /** @param {string} block @returns {string} */
  #bottomOf(block) {
    const below = this.#below.get(block);
    return below === undefined ? block : this.#bottomOf(below);
  }
  #clear() {
    this.#below.clear();
    this.#chosen = '';
    this.#draw();
    this.written('');
  }

  /** @param {PointerEvent} event */
  #drop(event) {
    const block = this.#dragged;
    this.#dragged = '';
    if (!block) return;
    const under = document.elementFromPoint(event.clientX, event.clientY)?.closest('[data-block], .towers');
    const target = under && (under.getAttribute('data-block') ?? table);
    if (target && target !== block) this.#put(block, target);
  }
  /** @param {string} block */
  #choose(block) {
    if (this.#chosen && this.#chosen !== block) return this.#put(this.#chosen, block);
    this.#chosen = this.#chosen ? '' : block;
    this.#draw();
  }

  /** @param {string} name */
  #block(name) {
    const made = element(
      'button',
      { type: 'button', class: 'block', 'data-block': name, 'aria-pressed': String(name === this.#chosen) },
      clipped(name, 20),
    );
    made.addEventListener('pointerdown', (event) => {
      this.#dragged = name;
      made.releasePointerCapture?.(event.pointerId);
    });
    made.addEventListener('click', () => this.#choose(name));
    return made;
  }
  #draw() {
    const bottoms = this.#names.filter((name) => !this.#below.has(name));
    this.#ground.replaceChildren(
      ...bottoms.map((bottom) =>
        element('div', { class: 'tower' }, ...this.#tower(bottom).toReversed().map((name) => this.#block(name))),
      ),
    );
  }
}

// Beside the goal's field; the blocks are what has been learned and can be put on another.
export function showTowers() {
  const towers = new Towers((goal) => (find('goal-text').value = goal));
  const toggle = element(
    'button',
    { type: 'button', id: 'sketch-toggle', 'aria-expanded': 'false', 'aria-controls': 'sketch' },
    'Sketch',
  );
  /** @param {boolean} open */
  const show = (open) => {
    towers.panel.hidden = !open;
    toggle.setAttribute('aria-expanded', String(open));
  };
  toggle.addEventListener('click', () => show(Boolean(towers.panel.hidden)));
  find('goal-form').addEventListener('submit', () => show(false));
  find('cancel').before(toggle);
  find('goal-answer').before(towers.panel);
  return towers;
}
