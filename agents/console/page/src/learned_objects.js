// What the eyes know: every learned sample by name and number, with its parameters (the thesis' Table C.1), its picture
// and what it may be mixed up with.
//
//   const objects = new LearnedObjects(roles);              of those eyes that play the role
//   objects.onChange(() => objects.names());
//   objects.samples('circle')        [{ eyes, num, parameters, picture, tone }, ...]

import { text } from './datum.js';

/** @import { Roles } from './roles.js' */
/** @import { Form } from './messages' */

// The triangle on the gripper: the first of every list.
export const endEffector = 'end-effector';

// What a page learned and nobody has named yet has a name of that page's until then.
const provisional = 'unnamed-';
/** @param {string} of what tells the page from others */
export const provisionalName = (of) => provisional + of;
/** @param {string} name */
export const isNamed = (name) => !name.startsWith(provisional);

const parameters = ['Area', 'Perimeter', 'NF', 'M0', 'M1', 'M2'];

/** @typedef {{ eyes: string, num: number, parameters: [name: string, value: string][], picture: string, tone: string }} Sample */

export class LearnedObjects {
  /** @type {Form[]} */
  #learned = [];
  /** @type {Map<string, Form>} */
  #templates = new Map();
  /** @type {Form[]} */
  #alike = [];
  /** @type {(() => void)[]} */
  #listeners = [];

  /** @param {Roles} roles */
  constructor(roles) {
    /** @param {string} query @param {(facts: Form[]) => void} listener */
    const follow = (query, listener) =>
      roles.follow('eyes', query, (facts) => {
        listener(facts);
        this.#changed();
      });
    follow('(learned ?eyes ?name ?num ?area ?perimeter ?nf ?m0 ?m1 ?m2)', (facts) => (this.#learned = facts));
    follow('(learned-template ?eyes ?name ?num ?tone ? ? ? ? ? ? ?picture)', (facts) => {
      this.#templates = new Map(facts.map((row) => [`${row[1]} ${row[2]} ${row[3]}`, row]));
    });
    follow('(look-alike ?eyes ?name ?other ?error ?sentence)', (facts) => (this.#alike = facts));
  }

  /** @param {() => void} listener */
  onChange(listener) {
    this.#listeners.push(listener);
  }
  #changed() {
    for (const listener of this.#listeners) listener();
  }

  names() {
    const names = [...new Set(this.#learned.map((row) => text(row[2])))].sort();
    return names.includes(endEffector) ? [endEffector, ...names.filter((name) => name !== endEffector)] : names;
  }
  /** @param {string} name */
  samples(name) {
    return this.#learned.filter((row) => text(row[2]) === name).map((row) => this.#shown(row));
  }
  /** @param {string} name */
  newest(name) {
    return this.samples(name).toSorted((a, b) => b.num - a.num)[0];
  }
  // Sentences.
  /** @param {string} name */
  alike(name) {
    return this.#alike.filter((row) => [text(row[2]), text(row[3])].includes(name)).map((row) => text(row[5]));
  }

  /** @param {Form} row @returns {Sample} */
  #shown(row) {
    const template = this.#templates.get(`${row[1]} ${row[2]} ${row[3]}`);
    const values = row.slice(4).map((value, i) => /** @type {[string, string]} */ ([parameters[i], value.toFixed(Number.isInteger(value) ? 0 : 3)]));
    return {
      eyes: text(row[1]),
      num: row[3],
      parameters: values,
      picture: template ? text(template.at(-1)) : '',
      tone: template ? text(template[4]) : 'dark',
    };
  }
}
