// Asks once more before what sets an arm free.

import { find } from './dom.js';

export function confirmed(question) {
  const dialog = find('confirm');
  find('confirm-text').textContent = question;
  dialog.returnValue = 'no';
  dialog.showModal();
  return new Promise((resolve) => {
    dialog.addEventListener('close', () => resolve(dialog.returnValue === 'yes'), { once: true });
  });
}
