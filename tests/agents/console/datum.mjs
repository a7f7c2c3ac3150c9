// node datum.mjs: the page reads and writes what the board's reader does.

import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { expect, pageFolder } from './browser.mjs';

const { read, write, text, Sym } = await import(pathToFileURL(join(pageFolder, 'src/datum.js')));

const same = (source) => expect(write(read(source)) === source, `${source} comes back as it was`);
for (const source of [
  '()',
  '(on circle triangle)',
  '(a (b (c 1 -2 2.5)) "x")',
  '(say "a \\"b\\" \\\\ (c; d)\\n\\te")',
  '(- +x <script> ?x a/b)',
])
  same(source);
expect(write(read(' ( a ; not this ) \n "b" ) ')) === '(a "b")', 'blanks and comments are left out');
const [name, string, number] = read('(circle "circle" 1e3)').values();
expect(
  name instanceof Sym && typeof string === 'string' && number === 1000,
  'a symbol, a string and a number are three things',
);
expect(text(name) === text(string), 'and the first two read alike');
expect(write(['\u0000\u0007']) === '("  ")', 'what no string may hold becomes blanks');
expect(Array.isArray(read(')')) && read(')').length === 0, 'what cannot be read is nothing');
