// What a client of the board is called before people: this page, another page of this console or of another, the key of
// who logged in; others by their own name.
//
//   nameOf('console-812-2', 'console-812-1')            page 2
//   nameOf('anna/console-812-3', 'console-812-1')       anna, page 3
//   asComponents('console-812-2 → robot', 'console-812-1')       console page 2 → robot

export const you = 'you';

/** @param {string} client @param {string} me */
export function nameOf(client, me) {
  if (client === me) return you;
  const page = /^(?:(.+)\/)?console-(\d+)-(\d+)$/;
  const [, key, console, number] = client.match(page) ?? [];
  if (!number) return client;
  const elsewhere = console === me.match(page)?.[2] ? '' : ` of console ${console}`;
  return `${key ? `${key}, ` : ''}page ${number}${elsewhere}`;
}

// The same in a text that names components of the cell, of which a page is one.
/** @param {string} text @param {string} me */
export const asComponents = (text, me) =>
  text.replace(/(?<![\w./-])(?:[\w.-]+\/)?console-\d+-\d+(?![\w-])/g, (client) => {
    if (client === me) return 'this page';
    return client.includes('/') ? nameOf(client, me) : `console ${nameOf(client, me)}`;
  });
