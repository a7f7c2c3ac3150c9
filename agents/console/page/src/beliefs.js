// The objects in words, beside the arm's numbers: how sure the eyes are of each, and how far its distance may be off.

import { clipped, eachFrame, element, find } from './dom.js';
import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Sighting } from './sightings.js' */

const shown = 8;

/** @param {Sighting | undefined} sighting */
function wordsOf(sighting) {
  if (!sighting) return 'not looked for';
  const { state, confidence, spread } = sighting;
  if (state !== 'seen' && state !== 'found') return state;
  const sure = confidence === undefined ? state : `${(confidence * 100).toFixed(0)} %`;
  return spread && spread > 0 ? `${sure}  ±${(2 * spread).toFixed(1)} mm` : sure;
}

// Answers what is told whenever the eyes have looked.
/** @param {Connection} connection */
export function showBeliefs(connection) {
  const list = find('beliefs');
  /** @type {string[]} */
  let names = [];
  /** @type {Map<string, Sighting>} */
  let seen = new Map();
  const draw = eachFrame(() => {
    const rows = names.slice(0, shown).flatMap((name) => [element('dt', {}, clipped(name, 16)), element('dd', {}, wordsOf(seen.get(name)))]);
    const more = names.length > shown ? [element('dt', {}, 'and'), element('dd', {}, `${names.length - shown} more`)] : [];
    list.replaceChildren(...rows, ...more);
  });
  connection.follow('(place ?name ?x ?y ?z ?frame)', (answers) => {
    names = answers.map((answer) => text(fact(answer)[1])).sort();
    draw();
  });
  /** @param {Map<string, Sighting>} sightings */
  return (sightings) => {
    seen = sightings;
    draw();
  };
}
