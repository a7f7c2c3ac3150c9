// What may be typed in a goal: the domain's predicates, of what has been learned and of what else they were seen to hold.
//
//   const vocabulary = new GoalVocabulary(connection, (names) => ...);     who is told of the learned objects
//   nextWords(source, vocabulary.words())

import { fact } from './live_answers.js';
import { isNamed } from './learned_objects.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer, Form } from './messages' */

const carried = 'end-effector';

// The domain's predicates: what whoever pursues goals both posts and reads of symbols alone, and keeps nowhere.
/** @param {Answer[]} contracts */
function predicatesIn(contracts) {
  /** @type {Map<string, number>} */
  const found = new Map();
  for (const [, , contract] of contracts.map(fact)) {
    /** @param {string} name @returns {Form[]} */
    const part = (name) => contract.filter((/** @type {Form} */ each) => text(each[0]) === name).flatMap((/** @type {Form} */ each) => each.slice(1));
    if (!part('offers').some((offer) => text(offer[0]) === 'goal')) continue;
    const read = new Set(part('reads').map(text));
    for (const [, name, args, ...rest] of part('posts')) {
      const isPredicate = read.has(text(name)) && args.every((/** @type {Form} */ [, type]) => text(type) === 'symbol');
      if (isPredicate && !rest.some((option) => text(option[0]) === 'durable')) found.set(text(name), args.length);
    }
  }
  return found;
}

export class GoalVocabulary {
  /** @type {string[]} */
  #learned = [];
  /** @type {string[]} */
  #believed = [];
  /** @type {Map<string, number>} */
  #predicates = new Map(); // by name, of so many arguments

  /** @param {Connection} connection @param {(names: string[]) => void} learned */
  constructor(connection, learned) {
    connection.follow('(contract ?name ?form)', (answers) => (this.#predicates = predicatesIn(answers)));
    connection.follow('(believed ?fact)', (answers) => {
      this.#believed = answers.flatMap((believed) => fact(believed)[1].slice(1).map(text));
    });
    connection.follow('(learned ?eyes ?name 1 ? ? ? ? ? ?)', (answers) => {
      const names = answers.map((one) => text(fact(one)[2])).filter((name) => name !== carried && isNamed(name));
      this.#learned = [...new Set(names)];
      learned(this.#learned);
    });
  }

  words() {
    return { predicates: this.#predicates, names: [...new Set([...this.#learned, ...this.#believed])].sort() };
  }
}
