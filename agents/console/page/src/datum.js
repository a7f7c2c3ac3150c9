// The language of the board, as its strict reader reads it: lists, strings, numbers and symbols.
//
//   read('(on circle "a b" 2.5)')     [Sym on, Sym circle, 'a b', 2.5]
//   write([sym('goal'), 7, 'text'])   (goal 7 "text")

/** @import { Datum, Form } from './messages' */

export class Sym {
  /** @param {string} name */
  constructor(name) {
    this.name = name;
  }
  toString() {
    return this.name;
  }
}

/** @param {string} name */
export const sym = (name) => new Sym(name);

// A symbol's name or a string; '' for anything else.
/** @param {unknown} datum */
export const text = (datum) => (datum instanceof Sym ? datum.name : typeof datum === 'string' ? datum : '');

const token = /\s*(?:;[^\n]*\n\s*)*(\(|\)|"(?:[^"\\]|\\.)*"|[^\s()";]+)/y;
/** @type {Record<string, string>} */
const escapes = { n: '\n', t: '\t' };

/** @param {string} found */
function atom(found) {
  if (found[0] === '"') return found.slice(1, -1).replace(/\\(.)/gs, (_, c) => escapes[c] ?? c);
  return /^[-+]?\d/.test(found) ? Number(found) : new Sym(found);
}

// Facts come from a board that has read them: what cannot be read here is a bug, and becomes an empty list.
/** @param {string} source @returns {Form} */
export function read(source) {
  token.lastIndex = 0;
  /** @type {Form[]} */
  const open = [[]];
  while (true) {
    const found = token.exec(source);
    if (!found) break;
    if (found[1] === '(') {
      open.push([]);
    } else if (found[1] === ')') {
      const list = open.pop();
      if (open.length === 0) return [];
      open[open.length - 1].push(list);
    } else {
      open[open.length - 1].push(atom(found[1]));
    }
  }
  return open[0][0] ?? [];
}

/** @param {string} string */
const quoted = (string) =>
  `"${string
    .replace(/[\\"]/g, '\\$&')
    .replace(/\n/g, '\\n')
    .replace(/\t/g, '\\t')
    .replace(/[\0-\x08\x0b-\x1f]/g, ' ')}"`;

/** @param {Datum} datum @returns {string} */
export function write(datum) {
  if (Array.isArray(datum)) return `(${datum.map(write).join(' ')})`;
  return typeof datum === 'string' ? quoted(datum) : String(datum);
}
