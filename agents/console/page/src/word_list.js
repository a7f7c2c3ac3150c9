// The words that a field offers: a list below it of which one is chosen. The focus stays in the field.
//
//   const words = new WordList(input, (index) => ...);       who takes the word that a pointer presses
//   words.offer(['on', 'at']); words.choose(1); words.close();

import { element } from './dom.js';

export class WordList {
  #input;
  #take;
  #list;
  chosen = -1; // -1: none

  /** @param {HTMLInputElement} input @param {(index: number) => void} take */
  constructor(input, take) {
    this.#input = input;
    this.#take = take;
    const id = `${input.id}-words`;
    this.#list = element('ul', { id, class: 'words', role: 'listbox', 'aria-label': 'What may come next', hidden: true });
    input.after(this.#list);
    const roles = { role: 'combobox', 'aria-autocomplete': 'list', 'aria-expanded': 'false', 'aria-controls': id };
    for (const [name, value] of Object.entries(roles)) input.setAttribute(name, value);
  }

  get isOpen() {
    return !this.#list.hidden;
  }
  /** @param {string[]} words */
  offer(words) {
    this.#list.replaceChildren(...words.map((word, index) => this.#item(word, index)));
    if (words.length === 0) return this.close();
    this.#list.hidden = false;
    this.#input.setAttribute('aria-expanded', 'true');
    this.choose(-1);
  }
  /** @param {number} index */
  choose(index) {
    this.chosen = index;
    const items = [...this.#list.children];
    items.forEach((item, i) => item.setAttribute('aria-selected', String(i === index)));
    if (index < 0) return this.#input.removeAttribute('aria-activedescendant');
    this.#input.setAttribute('aria-activedescendant', items[index].id);
    items[index].scrollIntoView({ block: 'nearest' });
  }
  // The next or the one before, round and round; upwards from none the last.
  /** @param {1 | -1} step */
  move(step) {
    const count = this.#list.children.length;
    const from = this.chosen < 0 && step < 0 ? 0 : this.chosen;
    this.choose((from + step + count) % count);
  }
  close() {
    this.#list.hidden = true;
    this.choose(-1);
    this.#input.setAttribute('aria-expanded', 'false');
  }

  /** @param {string} word @param {number} index */
  #item(word, index) {
    const item = element('li', { role: 'option', id: `${this.#list.id}-${index}`, 'aria-selected': 'false' }, word);
    // Before the field loses the focus.
    item.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      this.#take(index);
    });
    return item;
  }
}
