// A field that offers what may come next where the cursor is: chosen with the arrow keys and Enter or Tab, or by
// pointer. `next` answers { from, words: [{ word, put }] } of the text before the cursor.

import { element } from './dom.js';

const most = 12;

/** @typedef {{ from: number, words: { word: string, put: string }[] }} Offer */

/** @param {HTMLInputElement} input @param {(before: string) => Offer} next */
export function completes(input, next) {
  const list = element('ul', { id: `${input.id}-words`, class: 'words', role: 'listbox', 'aria-label': 'What may come next', hidden: true });
  input.after(list);
  for (const [name, value] of Object.entries({ role: 'combobox', 'aria-autocomplete': 'list', 'aria-expanded': 'false', 'aria-controls': list.id }))
    input.setAttribute(name, value);
  /** @type {Offer} */
  let offered = { from: 0, words: [] };
  let chosen = -1;
  const cursorOf = () => input.selectionStart ?? 0;

  /** @param {number} index */
  const choose = (index) => {
    chosen = index;
    [...list.children].forEach((item, i) => item.setAttribute('aria-selected', String(i === chosen)));
    if (chosen < 0) return input.removeAttribute('aria-activedescendant');
    input.setAttribute('aria-activedescendant', list.children[chosen].id);
    list.children[chosen].scrollIntoView({ block: 'nearest' });
  };
  const close = () => {
    list.hidden = true;
    choose(-1);
    input.setAttribute('aria-expanded', 'false');
  };
  /** @param {number} index */
  const take = (index) => {
    const cursor = cursorOf();
    input.setRangeText(offered.words[index].put, offered.from, cursor, 'end');
    input.dispatchEvent(new Event('input', { bubbles: true }));
  };
  const offer = () => {
    offered = next(input.value.slice(0, cursorOf()));
    const items = offered.words.slice(0, most).map(({ word }, i) => {
      const item = element('li', { role: 'option', id: `${list.id}-${i}`, 'aria-selected': 'false' }, word);
      // Before the field loses the focus.
      item.addEventListener('pointerdown', (event) => {
        event.preventDefault();
        take(i);
      });
      return item;
    });
    list.replaceChildren(...items);
    if (items.length === 0) return close();
    list.hidden = false;
    input.setAttribute('aria-expanded', 'true');
    choose(-1);
  };
  const wordBegun = () => cursorOf() > offered.from;

  input.addEventListener('input', offer);
  input.addEventListener('blur', close);
  input.addEventListener('keydown', (event) => {
    const count = list.children.length;
    if (list.hidden) {
      if (event.key === 'ArrowDown') offer();
    } else if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
      event.preventDefault();
      choose((chosen + (event.key === 'ArrowDown' ? 1 : chosen < 0 ? 0 : -1) + count) % count);
    } else if ((event.key === 'Enter' && chosen >= 0) || (event.key === 'Tab' && !event.shiftKey && (chosen >= 0 || wordBegun()))) {
      event.preventDefault();
      take(Math.max(chosen, 0));
    } else if (event.key === 'Enter' || event.key === 'Escape') {
      close();
    }
  });
}
