// A field that offers what may come next where the cursor is: chosen with the arrow keys and Enter or Tab, or by
// pointer. `next` answers { from, words: [{ word, put }] } of the text before the cursor.

import { WordList } from './word_list.js';

const most = 12;

/** @typedef {{ from: number, words: { word: string, put: string }[] }} Offer */

/** @param {HTMLInputElement} input @param {(before: string) => Offer} next */
export function completes(input, next) {
  /** @type {Offer} */
  let offered = { from: 0, words: [] };
  const cursorOf = () => input.selectionStart ?? 0;
  /** @param {number} index */
  const take = (index) => {
    input.setRangeText(offered.words[index].put, offered.from, cursorOf(), 'end');
    input.dispatchEvent(new Event('input', { bubbles: true }));
  };
  const list = new WordList(input, take);
  const offer = () => {
    offered = next(input.value.slice(0, cursorOf()));
    list.offer(offered.words.slice(0, most).map(({ word }) => word));
  };
  /** @param {KeyboardEvent} event */
  const takes = ({ key, shiftKey }) => {
    if (key === 'Enter') return list.chosen >= 0;
    return key === 'Tab' && !shiftKey && (list.chosen >= 0 || cursorOf() > offered.from);
  };

  input.addEventListener('input', offer);
  input.addEventListener('blur', () => list.close());
  input.addEventListener('keydown', (event) => {
    if (!list.isOpen) {
      if (event.key === 'ArrowDown') offer();
    } else if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
      event.preventDefault();
      list.move(event.key === 'ArrowDown' ? 1 : -1);
    } else if (takes(event)) {
      event.preventDefault();
      take(Math.max(list.chosen, 0));
    } else if (event.key === 'Enter' || event.key === 'Escape') {
      list.close();
    }
  });
}
