// node names.mjs: a page calls people, pages and components of the cell by names that a person understands.

import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { expect, pageFolder } from './browser.mjs';

const { asComponents, nameOf } = await import(pathToFileURL(join(pageFolder, 'src/names.js')));

const me = 'console-812-1';
for (const [client, name] of [
  [me, 'you'],
  ['console-812-2', 'page 2'],
  ['console-97-2', 'page 2 of console 97'],
  ['anna/console-812-3', 'anna, page 3'],
  ['robot', 'robot'],
])
  expect(nameOf(client, me) === name, `${client} is ${name}`);
for (const [said, shown] of [
  [me, 'this page'],
  ['console-812-2', 'console page 2'],
  ['anna/console-812-3', 'anna, page 3'],
  ['console-812-12 watches on, robot told by console-812-1', 'console page 12 watches on, robot told by this page'],
  ['console-812-pictures', 'console-812-pictures'],
  ['console-812-1-method', 'console-812-1-method'],
  ['my-console-812-1', 'my-console-812-1'],
])
  expect(asComponents(said, me) === shown, `"${said}" reads "${shown}": ${asComponents(said, me)}`);
