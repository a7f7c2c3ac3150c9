// Who comes from another machine logs in with the token of a key, and may do what that key may.

import { find } from './dom.js';

/** @import { Connection, State } from './connection.js' */

/** @param {Connection} connection */
export function showLogIn(connection) {
  const abroad = location.protocol === 'https:';
  find('refused-here').hidden = abroad;
  find('log-in').hidden = !abroad;
  find('log-out').hidden = !abroad;
  find('log-out').addEventListener('click', () => connection.logOut());
  let tried = false;
  find('log-in').addEventListener('submit', (event) => {
    event.preventDefault();
    tried = true;
    find('log-in-wrong').textContent = '';
    connection.logIn(find('token').value.trim());
    find('token').value = '';
  });
  /** @param {State} state @param {string} why a session has ended */
  return (state, why = '') => {
    if (state === 'live') {
      tried = false;
      find('refused').close();
    }
    if (state === 'refused') find('log-in-wrong').textContent = tried ? 'This token is wrong.' : why;
    if (state === 'refused' && !find('refused').open) find('refused').showModal();
  };
}
