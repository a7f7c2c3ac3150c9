// What the eyes say of each object: in their newest look, and of what they do not look for, when it was found last.
//
//   const seen = sightingsIn(looks, found);
//   seen.get('circle')      what is not told is undefined
//   followSightings(connection, (seen) => ...)
//
// Where several eyes tell of an object, the surest count. `covariance` is that of its place in the frame of the eyes
// (camera_frame.js): xx xy xz yy yz zz.

import { fact } from './live_answers.js';
import { text } from './datum.js';

/** @import { Connection } from './connection.js' */
/** @import { Answer, Datum, Form } from './messages' */

/** @typedef {{ state: string, confidence?: number, range?: number, spread?: number, covariance?: number[] }} Sighting */

// Of the upper triangle, row by row, of a place and a turn: what concerns the place.
const ofPlace = [0, 1, 2, 6, 7, 11];
const inTriangle = 21;

/** @param {Datum[]} parts */
function partsIn(parts) {
  /** @param {string} name @returns {Form} */
  const part = (name) => parts.filter(Array.isArray).find((one) => text(one[0]) === name) ?? [];
  const [, range, spread] = part('range');
  const triangle = part('pose')[7];
  const told = Array.isArray(triangle) && triangle.length === inTriangle && triangle.every(Number.isFinite);
  return { range, spread, covariance: told ? ofPlace.map((i) => triangle[i]) : undefined };
}

/** @param {Map<string, Sighting>} seen @param {string} name @param {Sighting} sighting */
function addSurest(seen, name, sighting) {
  const known = seen.get(name);
  if (!known || (known.confidence ?? 0) < (sighting.confidence ?? 0)) seen.set(name, sighting);
}

/** @param {Answer[]} looks @param {Answer[]} found */
export function sightingsIn(looks, found) {
  /** @type {Map<string, Sighting>} */
  const seen = new Map();
  for (const [, , , , objects] of looks.map(fact)) {
    for (const [name, state, ...parts] of objects) {
      const confidence = typeof parts[0] === 'number' ? parts[0] : undefined;
      addSurest(seen, text(name), { state: text(state), confidence, ...partsIn(parts) });
    }
  }
  const lookedFor = new Set(seen.keys());
  for (const [, , name, , confidence, , , , places] of found.map(fact)) {
    if (!lookedFor.has(text(name))) addSurest(seen, text(name), { state: 'found', confidence, ...partsIn(places) });
  }
  return seen;
}

// Tells them anew whenever the eyes have looked.
/** @param {Connection} connection @param {(seen: Map<string, Sighting>) => void} changed */
export function followSightings(connection, changed) {
  /** @type {Record<'looks' | 'found', Answer[]>} */
  const told = { looks: [], found: [] };
  /** @param {'looks' | 'found'} name @param {string} query */
  const follow = (name, query) =>
    connection.follow(query, (answers) => {
      told[name] = answers;
      changed(sightingsIn(told.looks, told.found));
    });
  follow('looks', '(look ?eyes ?frame ?text ?of)');
  follow('found', '(found ?eyes ?name ?frame ?confidence ?second ?margin ?others ?places)');
}
