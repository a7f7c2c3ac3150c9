// What may come next where a goal is typed: words of the language of goals, the domain's predicates, names of objects.
//
//   nextWords('(on ci', { predicates: new Map([['on', 2]]), names: ['circle'] })
//     { from: 4, words: [{ word: 'circle', put: 'circle ' }] }

/** @import { Offer } from './completion.js' */

const formulas = ['and', 'or', 'not', 'then', 'keep'];

// The form that is open where the text ends: its head, '' where it is still to come, and what stands behind it; null
// where none is open.
/** @param {string} source */
function openForm(source) {
  /** @type {string[][]} */
  const open = [];
  for (const [token] of source.matchAll(/[()]|[^\s()]+/g)) {
    if (token === '(') open.push([]);
    else if (token === ')') {
      open.pop();
      open.at(-1)?.push('()');
    } else open.at(-1)?.push(token);
  }
  const innermost = open.at(-1);
  if (!innermost) return null;
  const [head = '', ...rest] = innermost;
  return { head, rest };
}

/** @param {string} source @param {{ predicates: Map<string, number>, names: string[] }} known @returns {Offer} */
export function nextWords(source, { predicates, names }) {
  const typed = source.match(/[^\s()]*$/)?.[0] ?? '';
  const before = source.slice(0, source.length - typed.length);
  const form = openForm(before);
  const heads = [...predicates.keys(), ...formulas];
  /** @param {string[]} words @param {(word: string) => string} put */
  const found = (words, put) =>
    words.filter((word) => word !== typed && word.startsWith(typed.toLowerCase())).map((word) => ({ word, put: put(word) }));
  /** @param {Offer['words']} words @returns {Offer} */
  const answer = (words) => ({ from: before.length, words });
  if (!form && typed === '' && before.trim() !== '') return answer([]);
  if (!form || formulas.includes(form.head)) return answer(found(heads, (word) => `(${word} `));
  if (form.head === '') return answer(found(heads, (word) => `${word}${predicates.get(word) === 0 ? ')' : ' '}`));
  const wanted = predicates.get(form.head.toLowerCase());
  if (wanted === undefined) return answer(found(names, (word) => `${word} `));
  const left = wanted - form.rest.length;
  if (left <= 0) return answer([]);
  const free = names.filter((name) => !form.rest.includes(name));
  return answer(found(free, (word) => `${word}${left === 1 ? ')' : ' '}`));
}
