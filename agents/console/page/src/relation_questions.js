// The question for all facts of a relation, by the relation's name, as far as a contract tells the relation's form.
//
//   const questions = new RelationQuestions(connection);
//   questions.of('arm-joints')        '(arm-joints ?robot ?joints)'; undefined where no contract tells it
//   questions.list                    offers them while a question is typed

import { element } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer, Form } from './messages' */

// Of `(relation on ((a symbol) (b symbol)) ...)`.
/** @param {Form} relation */
const questionFor = ([, name, args]) =>
  `(${text(name)}${args.map((/** @type {Form} */ argument) => ` ?${text(argument[0])}`).join('')})`;

// Those that a contract posts with their arguments.
/** @param {Answer} contract @returns {Form[]} */
function relationsIn(contract) {
  const parts = fact(contract)[2].filter((/** @type {Form} */ part) => Array.isArray(part) && text(part[0]) === 'posts');
  return parts.flatMap((/** @type {Form} */ part) => part.slice(1)).filter((/** @type {Form} */ one) => Array.isArray(one?.[2]));
}

export class RelationQuestions {
  /** @type {Map<string, string>} */
  #questions = new Map();
  list = element('datalist', { id: 'questions' });

  /** @param {Connection} connection */
  constructor(connection) {
    connection.follow('(contract ?name ?form)', (answers) => {
      this.#questions = new Map(answers.flatMap(relationsIn).map((relation) => [text(relation[1]), questionFor(relation)]));
      const sorted = [...this.#questions.values()].sort();
      this.list.replaceChildren(...sorted.map((question) => element('option', { value: question })));
    });
  }

  /** @param {string} relation */
  of(relation) {
    return this.#questions.get(relation);
  }
}
