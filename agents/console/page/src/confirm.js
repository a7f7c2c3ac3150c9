// Asks once more before what sets an arm free.

import { find } from './dom.js';

// What is pressed answers. A close event may be late: one that comes while the dialog is open is of the question before.
/** @param {string} question @returns {Promise<boolean>} */
export function confirmed(question) {
  const dialog = find('confirm');
  find('confirm-text').textContent = question;
  dialog.showModal();
  return new Promise((resolve) => {
    const asked = new AbortController();
    /** @param {boolean} yes */
    const answer = (yes) => {
      asked.abort();
      resolve(yes);
    };
    dialog.addEventListener('submit', (event) => answer(event.submitter?.getAttribute('value') === 'yes'), { signal: asked.signal });
    dialog.addEventListener('close', () => dialog.open || answer(false), { signal: asked.signal });
  });
}
