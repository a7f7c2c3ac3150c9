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
  /** @param {State} state */
  return (state) => {
    if (state === 'live') find('refused').close();
    if (state === 'refused' && tried) find('log-in-wrong').textContent = 'This token is wrong.';
    if (state === 'refused' && !find('refused').open) find('refused').showModal();
  };
}
